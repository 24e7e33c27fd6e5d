#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <tuple>

#include "engine/spatial/types.h"

namespace hazumi {

// Rigid placement of frame B in frame A, written X_AB: p_AB + R_AB * x takes B coordinates to A.
// Lengths in metres. R must be a rotation matrix.
template <typename T>
struct PoseOf {
  Mat3Of<T> R = Mat3Of<T>::Identity();
  Vec3Of<T> p = Vec3Of<T>::Zero();

  PoseOf operator*(const PoseOf& X_BC) const { return {R * X_BC.R, p + R * X_BC.p}; }
  Vec3Of<T> operator*(const Vec3Of<T>& p_B) const { return p + R * p_B; }
  PoseOf Inverse() const { return {R.transpose(), -(R.transpose() * p)}; }
  bool operator==(const PoseOf&) const = default;
};

template <typename T>
auto MembersOf(const PoseOf<T>& X) {
  const auto& [R, p] = X;
  return std::tie(R, p);
}

using Pose = PoseOf<double>;

// Rotation by `angle` [rad] about the unit vector `axis` (Rodrigues), from its sine and cosine.
template <typename T>
Mat3Of<T> AxisRotation(const Vec3& axis, const T& sine, const T& cosine) {
  const T v = T(1) - cosine;
  const double x = axis.x(), y = axis.y(), z = axis.z();
  Mat3Of<T> R;
  R << v * (x * x) + cosine, v * (x * y) - sine * z, v * (x * z) + sine * y,  //
      v * (x * y) + sine * z, v * (y * y) + cosine, v * (y * z) - sine * x,   //
      v * (x * z) - sine * y, v * (y * z) + sine * x, v * (z * z) + cosine;
  return R;
}

// R := R AxisRotation(axis, ...). About a coordinate axis only two columns change.
template <typename T>
void Turn(const Vec3& axis, const T& sine, const T& cosine, Mat3Of<T>* R) {
  for (int k = 0; k < 3; ++k) {
    if (std::abs(axis[k]) != 1.0) continue;
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    const T s = sine * T(axis[k]);
    const Vec3Of<T> was = R->col(i);
    R->col(i) = was * cosine + R->col(j) * s;
    R->col(j) = R->col(j) * cosine - was * s;
    return;
  }
  *R = (*R * AxisRotation<T>(axis, sine, cosine)).eval();
}

// The turn r [rad] about an axis that leads from one orientation to another: exp(r) from = to.
inline Vec3 TurnBetween(const Mat3& from, const Mat3& to) {
  const Eigen::AngleAxisd turn(to * from.transpose());
  return turn.angle() * turn.axis();
}

}  // namespace hazumi
