#include <optional>

#include "engine/analysis/object_landing.h"
#include "engine/analysis/problems/problems.h"
#include "engine/collision/distance.h"

namespace hazumi {

namespace {

constexpr double kDeep = 0.01;  // less is not worth a word [m]

std::optional<FallThrough> In(const Animation& animation, const Vec3& p, double radius) {
  for (const SceneObject& obstacle : animation.scene) {
    const Distance distance = SignedDistance(Capsule{p, p, radius}, obstacle.shape);
    if (distance.value > -kDeep) continue;
    FallThrough fall;
    fall.obstacle = obstacle.name;
    fall.outside = p - distance.value * distance.normal;
    fall.normal = distance.normal;
    return fall;
  }
  return std::nullopt;
}

}  // namespace

std::vector<FallThrough> FallsThrough(const Animation& animation, const Motion& motion) {
  std::vector<FallThrough> falls;
  for (size_t i = 0; i < animation.held_objects.size(); ++i) {
    const double radius = InnerRadius(animation.held_objects[i]);
    for (const MotionFrame& frame : motion.frames) {
      if (i >= frame.objects.size() || frame.objects[i].is_held()) continue;
      std::optional<FallThrough> fall = In(animation, frame.objects[i].X_WO.p, radius);
      if (!fall) continue;
      fall->object = static_cast<int>(i);
      fall->frame = frame.frame;
      falls.push_back(*fall);
      break;
    }
  }
  return falls;
}

}  // namespace hazumi
