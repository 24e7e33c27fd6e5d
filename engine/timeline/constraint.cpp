#include "engine/timeline/constraint.h"

#include <Eigen/Geometry>
#include <cmath>

namespace hazumi {

ConstraintGap GapBetween(const Constraint& constraint, const Pose& a, const Pose& b) {
  const double apart = (a.p - b.p).norm();
  if (constraint.kind == ConstraintKind::kDistance) {
    return {std::abs(apart - constraint.length), 0.0};
  }
  if (constraint.kind == ConstraintKind::kPoint) return {apart, 0.0};
  return {apart, Eigen::AngleAxisd(a.R * b.R.transpose()).angle()};
}

}  // namespace hazumi
