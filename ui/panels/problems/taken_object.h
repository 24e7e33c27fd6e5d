#pragma once

#include <optional>
#include <string>

#include "engine/bake/motion.h"
#include "engine/timeline/animation.h"

namespace hazumi::ui {

// Of a joint that takes a held object on a frame.
struct Taking {
  std::string joint;
  Vec3 object;  // where the object is until then [m]
  Vec3 offset;  // where it lies in the joint's frame from then on [m]
};

// `object`: of the animation's held objects. Nothing if none takes it on that frame.
std::optional<Taking> TakingAt(int object, int frame, const Animation& animation,
                               const Motion& motion);

}  // namespace hazumi::ui
