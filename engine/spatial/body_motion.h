#pragma once

#include <tuple>

#include "engine/spatial/pose.h"

namespace hazumi {

// A rigid body at an instant, with the velocity of its origin [m/s] and how it turns [rad/s].
// World axes.
struct BodyMotion {
  Pose X_WB;
  Vec3 v = Vec3::Zero(), w = Vec3::Zero();
  bool operator==(const BodyMotion&) const = default;
};
inline auto MembersOf(const BodyMotion& motion) {
  const auto& [X_WB, v, w] = motion;
  return std::tie(X_WB, v, w);
}

}  // namespace hazumi
