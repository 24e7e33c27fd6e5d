#pragma once

#include <tuple>

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

}  // namespace hazumi
