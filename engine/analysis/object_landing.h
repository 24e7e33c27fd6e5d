#pragma once

// Where what was let go comes down.

#include <optional>
#include <string>

#include "engine/bake/motion.h"
#include "engine/timeline/animation.h"

namespace hazumi {

struct ObjectLanding {
  Vec3 position = Vec3::Zero();  // of the object's centre, world [m]
  double time = 0.0;             // since frame 0 [s]
  std::string obstacle;          // of the scene, by name
};

// The first touch of an object, once it has been held and let go, with something of the scene; none
// if it touches nothing up to the motion's end or the next holder. A box counts as the sphere in
// its middle. Between frames the object is on its parabola: exact to rounding, unless keys
// move it there. `object`: of the animation's held objects.
std::optional<ObjectLanding> LandingOf(const Animation& animation, const Motion& motion,
                                       size_t object);

// Of the sphere in the middle of an object [m].
double InnerRadius(const HeldObject& object);

}  // namespace hazumi
