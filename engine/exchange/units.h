#pragma once

#include <Eigen/Geometry>
#include <numbers>

#include "engine/spatial/types.h"

namespace hazumi {

inline double Degrees(double radians) { return radians * (180.0 / std::numbers::pi); }

// The quaternion of R nearest to `previous` of the two that stand for it, so that a sequence has no
// sign flips.
inline Eigen::Quaterniond NearQuaternion(const Mat3& R, const Eigen::Quaterniond& previous) {
  Eigen::Quaterniond q(R);
  if (q.dot(previous) < 0.0) q.coeffs() = -q.coeffs();
  return q;
}

}  // namespace hazumi
