#pragma once

#include <tuple>

#include "engine/spatial/pose.h"
#include "engine/spatial/types.h"

namespace hazumi {

// A point and its velocity, in the world [m, m/s].
struct PointMotion {
  Vec3 p = Vec3::Zero(), v = Vec3::Zero();
  bool operator==(const PointMotion&) const = default;
};
inline auto MembersOf(const PointMotion& motion) {
  const auto& [p, v] = motion;
  return std::tie(p, v);
}

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
