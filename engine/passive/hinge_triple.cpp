#include "engine/passive/hinge_triple.h"

#include <cmath>
#include <numbers>
#include <utility>

// With g = q2 + beta and u = R a3:
//   u = cos g a1 + sin g (cos q1 (a2 x a1) + sin q1 a2)
// so that g and q1 follow from u, up to the sign of sin g, and q3 from what is left of R.

namespace hazumi {

namespace {

Mat3 Rot(const Vec3& axis, double angle) {
  return AxisRotation<double>(axis, std::sin(angle), std::cos(angle));
}

double Nearest(double angle, double to) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  return angle + kTurn * std::round((to - angle) / kTurn);
}

bool IsInside(const Vec3& q, const Vec3& lower, const Vec3& upper) {
  return (q.array() >= lower.array()).all() && (q.array() <= upper.array()).all();
}

}  // namespace

bool HingeTriple::Fits(const Vec3& a1, const Vec3& a2, const Vec3& a3) {
  constexpr double kRightAngle = 1e-9;
  return std::abs(a1.dot(a2)) < kRightAngle && std::abs(a2.dot(a3)) < kRightAngle;
}

HingeTriple::HingeTriple(const Vec3& a1, const Vec3& a2, const Vec3& a3)
    : a1_(a1), a2_(a2), a3_(a3), beta_(std::atan2(a2.cross(a1).dot(a3), a1.dot(a3))) {}

Mat3 HingeTriple::Rotation(const Vec3& q) const {
  return Rot(a1_, q[0]) * Rot(a2_, q[1]) * Rot(a3_, q[2]);
}

Vec3 HingeTriple::Branch(const Mat3& R, const Vec3& near, double side) const {
  constexpr double kAtPole = 1e-12;
  const Vec3 u = R * a3_;
  const Vec3 c = a2_.cross(a1_);
  const double sine = std::hypot(u.dot(a2_), u.dot(c));
  Vec3 q;
  q[0] = sine < kAtPole ? near[0] : std::atan2(side * u.dot(a2_), side * u.dot(c));
  q[1] = std::atan2(side * sine, u.dot(a1_)) - beta_;
  const Vec3 turned = Rot(a2_, q[1]).transpose() * (Rot(a1_, q[0]).transpose() * (R * a2_));
  q[2] = std::atan2(turned.dot(a3_.cross(a2_)), turned.dot(a2_));
  for (int i = 0; i < 3; ++i) q[i] = Nearest(q[i], near[i]);
  return q;
}

Vec3 HingeTriple::Angles(const Mat3& R, const Vec3& near, const Vec3& lower,
                         const Vec3& upper) const {
  Vec3 q = Branch(R, near, 1.0), other = Branch(R, near, -1.0);
  if ((other - near).lpNorm<1>() < (q - near).lpNorm<1>()) std::swap(q, other);
  const bool passed_pole = std::sin(near[1] + beta_) * std::sin(q[1] + beta_) <= 0.0;
  const bool turns_back =
      passed_pole && !IsInside(q, lower, upper) && IsInside(other, lower, upper);
  return turns_back ? other : q;
}

Mat3 HingeTriple::AxesInBody(const Vec3& q) const {
  const Mat3 R3 = Rot(a3_, -q[2]);
  Mat3 axes;
  axes.col(2) = a3_;
  axes.col(1) = R3 * a2_;
  axes.col(0) = R3 * (Rot(a2_, -q[1]) * a1_);
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

double HingeTriple::FromPole(double q2) const { return std::asin(std::abs(std::sin(q2 + beta_))); }

}  // namespace hazumi
