#include <algorithm>
#include <cmath>

#include "engine/project/edits/placements.h"
#include "engine/project/project.h"
#include "engine/spatial/degrees.h"

namespace hazumi {

namespace {

// [degrees]: z, y, x.
using Angles = std::array<double, 3>;

Angles LastKeyed(const ProjectRoot& root, double frame) {
  Angles angles = {};
  for (int i = 0; i < 3; ++i) {
    const std::vector<ProjectKey>& keys = root.curves[kRootAngleZ + i].keys;
    const auto later = std::find_if(keys.begin(), keys.end(),
                                    [&](const ProjectKey& key) { return key.frame > frame; });
    if (!keys.empty()) angles[i] = later == keys.begin() ? later->value : (later - 1)->value;
  }
  return angles;
}

Angles RootAnglesOf(const Mat3& R) {
  const double c = std::hypot(R(0, 0), R(1, 0));  // |cos y|
  const double y = std::atan2(-R(2, 0), c);
  // Looking straight up or down z and x turn about the same line: all of it is given to z.
  if (c < 1e-9) return {std::atan2(-R(0, 1), R(1, 1)) / kDegree, y / kDegree, 0.0};
  return {std::atan2(R(1, 0), R(0, 0)) / kDegree, y / kDegree,
          std::atan2(R(2, 1), R(2, 2)) / kDegree};
}

Angles WithoutTurns(Angles angles, const Angles& near) {
  for (int i = 0; i < 3; ++i) angles[i] = near[i] + std::remainder(angles[i] - near[i], 360.0);
  return angles;
}

double Between(const Angles& a, const Angles& b) {
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
}

// (z, y, x) and (z + 180, 180 - y, x + 180) are the same.
Angles NearestTo(const Angles& near, const Angles& angles) {
  const Angles one = WithoutTurns(angles, near);
  const Angles other =
      WithoutTurns({angles[0] + 180.0, 180.0 - angles[1], angles[2] + 180.0}, near);
  return Between(one, near) <= Between(other, near) + 1e-9 ? one : other;
}

}  // namespace

std::array<double, kNumRootCurves> RootValues(const Pose& X_WR, const ProjectRoot& root,
                                              double frame) {
  const Angles angles = NearestTo(LastKeyed(root, frame), RootAnglesOf(X_WR.R));
  return {X_WR.p.x(), X_WR.p.y(), X_WR.p.z(), angles[0], angles[1], angles[2]};
}

// w = z' Z + y' Rz Y + x' Rz Ry X.
std::optional<std::array<double, 3>> RootAngleRates(
    const std::array<double, kNumRootCurves>& values, const Vec3& w) {
  const double z = values[kRootAngleZ] * kDegree, y = values[kRootAngleY] * kDegree;
  constexpr double kSingular = 0.01;
  if (std::abs(std::cos(y)) < kSingular) return std::nullopt;
  const double across = w.y() * std::cos(z) - w.x() * std::sin(z);
  const double x_rate = (w.x() * std::cos(z) + w.y() * std::sin(z)) / std::cos(y);
  return std::array{(w.z() + x_rate * std::sin(y)) / kDegree, across / kDegree, x_rate / kDegree};
}

}  // namespace hazumi
