#pragma once

#include <string>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// What nobody holds goes into something of the scene: nothing stops it but keys.
struct FallThrough {
  int object = 0;  // of the animation's held objects
  int frame = 0;   // the first, of those that an animation numbers
  std::string obstacle;
  Vec3 outside = Vec3::Zero();  // where its centre would touch, world [m]
  Vec3 normal = Vec3::UnitZ();  // of what it touches there
};

// The first of each object. A box counts as the sphere in it.
std::vector<FallThrough> FallsThrough(const Animation& animation, const Motion& motion);

}  // namespace hazumi
