// Angles a, b, c of R = R_i(a) R_j(b) R_k(c) about three different axes i, j, k. With e = 1 if i j
// k is a cyclic order of x y z and e = -1 if not,
//   R(i, k) = e sin b,   R(i, i) = cos b cos c,   R(i, j) = -e cos b sin c,
// and a follows from R R_k(-c) = R_i(a) R_j(b), which leaves no error where cos b is small and
// c is hardly known.

#include "engine/spatial/euler_angles.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "engine/spatial/degrees.h"

namespace hazumi {

namespace {

Mat3 AboutAxis(int axis, double angle) {
  return Eigen::AngleAxisd(angle, Vec3::Unit(axis)).toRotationMatrix();
}

Vec3 Nearest(const Vec3& angles, const Vec3& previous) {
  return {NearestTurn(angles[0], previous[0]), NearestTurn(angles[1], previous[1]),
          NearestTurn(angles[2], previous[2])};
}

}  // namespace

std::optional<EulerAxes> EulerAxesOf(const std::string& order) {
  std::string all = order;
  for (const char c : {'X', 'Y', 'Z'}) {
    if (order.find(c) == order.npos) all += c;
  }
  if (all.size() != 3) return std::nullopt;
  EulerAxes axes{};
  for (size_t i = 0; i < 3; ++i) axes[i] = all[i] - 'X';
  return axes;
}

Mat3 EulerRotation(const EulerAxes& axes, const Vec3& angles) {
  return AboutAxis(axes[0], angles[0]) * AboutAxis(axes[1], angles[1]) *
         AboutAxis(axes[2], angles[2]);
}

Vec3 EulerAnglesNear(const Mat3& R, const EulerAxes& axes, const Vec3& previous) {
  const auto [i, j, k] = axes;
  const double e = (i + 1) % 3 == j ? 1.0 : -1.0;
  const double cos_b = std::hypot(R(i, i), R(i, j));
  const double b = std::atan2(e * R(i, k), cos_b);
  const double c = cos_b > 1e-12 ? std::atan2(-e * R(i, j), R(i, i)) : previous[2];
  const Mat3 rest = R * AboutAxis(k, -c);
  const double a = std::atan2(e * rest(k, j), rest(j, j));
  // Each rotation has two sets of angles, but for whole turns.
  const double half = std::numbers::pi;
  const Vec3 one = Nearest(Vec3(a, b, c), previous);
  const Vec3 other = Nearest(Vec3(a + half, half - b, c + half), previous);
  return (one - previous).norm() <= (other - previous).norm() ? one : other;
}

}  // namespace hazumi
