#include "engine/region/hinge_triple.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/spatial/degrees.h"

// With g = q2 + beta, u = R a3 and v = R^T a1:
//   u = cos g a1 + sin g (cos q1 (a2 x a1) + sin q1 a2)
//   v = cos g a3 + sin g (cos q3 (a3 x a2) + sin q3 a2)
// so that all three follow, up to the sign of sin g: (q1 + pi, -g, q3 + pi) is the same rotation.

namespace hazumi {

namespace {

constexpr double kAtPole = 1e-9;  // sine of the distance

Mat3 Rot(const Vec3& axis, double angle) {
  return AxisRotation<double>(axis, std::sin(angle), std::cos(angle));
}

}  // namespace

bool HingeTriple::Fits(const Vec3& a1, const Vec3& a2, const Vec3& a3) {
  constexpr double kRightAngle = 1e-9;
  return std::abs(a1.dot(a2)) < kRightAngle && std::abs(a2.dot(a3)) < kRightAngle;
}

HingeTriple::HingeTriple(const Vec3& a1, const Vec3& a2, const Vec3& a3)
    : a1_(a1),
      a2_(a2),
      a3_(a3),
      b1_(a2.cross(a1)),
      b3_(a3.cross(a2)),
      beta_(std::atan2(a2.cross(a1).dot(a3), a1.dot(a3))) {}

Mat3 HingeTriple::Rotation(const Vec3& q) const {
  return Rot(a1_, q[0]) * Rot(a2_, q[1]) * Rot(a3_, q[2]);
}

// Near a pole q1 and q3 are lost one by one: q1 stays where it was, and q3 is what is left of R.
Vec3 HingeTriple::AtPole(const Mat3& R, const Vec3& near, double g) const {
  Vec3 q(near[0], g - beta_, 0.0);
  const Vec3 turned = Rot(a2_, q[1]).transpose() * (Rot(a1_, q[0]).transpose() * (R * a2_));
  q[2] = std::atan2(turned.dot(a3_.cross(a2_)), turned.dot(a2_));
  return q;
}

Vec3 HingeTriple::ThroughPole(const Mat3& R, const Vec3& before) const {
  const Vec3 u = R * a3_;
  const double g = std::atan2(a1_.cross(u).norm(), a1_.dot(u));
  const double side = std::sin(before[1] + beta_) > 0.0 ? 1.0 : -1.0;
  Vec3 q = AtPole(R, before, -side * std::max(g, kAtPole));
  for (int i : {1, 2}) q[i] = NearestTurn(q[i], before[i]);
  return q;
}

Vec3 HingeTriple::Angles(const Mat3& R, const Vec3& near, bool keeps_side) const {
  const Vec3 u = R * a3_, v = R.transpose() * a1_;
  const double sine = std::hypot(u.dot(a2_), u.dot(b1_));
  const double g = std::atan2(sine, u.dot(a1_));
  Vec3 q(std::atan2(u.dot(a2_), u.dot(b1_)), g - beta_, std::atan2(v.dot(a2_), v.dot(b3_)));
  if (sine < kAtPole) q = AtPole(R, near, g);
  Vec3 other(q[0] + std::numbers::pi, -g - beta_, q[2] + std::numbers::pi);
  for (int i = 0; i < 3; ++i) {
    q[i] = NearestTurn(q[i], near[i]);
    other[i] = NearestTurn(other[i], near[i]);
  }
  const double side = std::sin(near[1] + beta_);
  if (keeps_side && sine >= kAtPole && std::abs(side) >= kAtPole) return side > 0.0 ? q : other;
  return (other - near).lpNorm<1>() < (q - near).lpNorm<1>() ? other : q;
}

// -sin g cos g g', half of how fast cos^2 g grows.
double HingeTriple::Approach(const Vec3& q, const Vec3& qd) const {
  return -std::sin(q[1] + beta_) * std::cos(q[1] + beta_) * qd[1];
}

Mat3 HingeTriple::AxesInBody(const Vec3& q) const {
  const double s = std::sin(q[2]), c = std::cos(q[2]), g = q[1] + beta_;
  Mat3 axes;
  axes.col(0) = std::cos(g) * a3_ + std::sin(g) * (c * b3_ + s * a2_);
  axes.col(1) = c * a2_ - s * b3_;
  axes.col(2) = a3_;
  return axes;
}

Vec3 HingeTriple::Rates(const Vec3& q, const Vec3& w) const {
  constexpr double kSingular = 1e-9;
  const Mat3 A = AxesInBody(q);
  const Vec3 a1 = A.col(0), a2 = A.col(1), a3 = A.col(2);
  const double det = a1.dot(a2.cross(a3));
  if (std::abs(det) < kSingular) return {0.0, w.dot(a2), w.dot(a3)};
  return Vec3(w.dot(a2.cross(a3)), w.dot(a3.cross(a1)), w.dot(a1.cross(a2))) / det;
}

// w = A qd, so qdd = A^-1 (w' - A' qd), of the columns of A as AxesInBody has them.
Vec3 HingeTriple::Accelerations(const Vec3& q, const Vec3& qd, const Vec3& w_rate) const {
  const double s = std::sin(q[2]), c = std::cos(q[2]), g = q[1] + beta_;
  const Vec3 first = qd[1] * (-std::sin(g) * a3_ + std::cos(g) * (c * b3_ + s * a2_)) +
                     qd[2] * std::sin(g) * (c * a2_ - s * b3_);
  const Vec3 second = -qd[2] * (s * a2_ + c * b3_);
  return Rates(q, w_rate - qd[0] * first - qd[1] * second);
}

double HingeTriple::FromPole(double q2) const { return std::asin(std::abs(std::sin(q2 + beta_))); }

}  // namespace hazumi
