#pragma once

#include <Eigen/Geometry>

#include "engine/spatial/types.h"

namespace hazumi {

// The turn r [rad] about an axis that leads from one orientation to another: exp(r) from = to.
inline Vec3 TurnBetween(const Mat3& from, const Mat3& to) {
  const Eigen::AngleAxisd turn(to * from.transpose());
  return turn.angle() * turn.axis();
}

}  // namespace hazumi
