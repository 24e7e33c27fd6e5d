#pragma once

// How strong a joint is: the torques that its muscles can give at an angle and a rate.

#include <tuple>

namespace hazumi {

// Of muscles that turn a hinge in one direction: the largest torque [N m] at an angle [rad] of the
// hinge and a rate [rad/s], which is positive where they shorten. Two measured forms and a
// constant: strength.cpp has the equations.
struct StrengthCurve {
  enum class Form {
    kConstant,  // `torque` at any angle and rate
    kCosine,    // [Anderson, Madigan, Nussbaum 2007]
    kBell,      // a normal distribution of the angle, Hill's hyperbola of the rate
  };
  Form form = Form::kConstant;
  double torque = 0.0;      // at rest and at the best angle [N m], > 0
  double best_angle = 0.0;  // [rad]
  double width = 1.0;       // kCosine: 1 / C2; kBell: standard deviation [rad], > 0
  // kCosine: the rates at which three quarters and half of it are left [rad/s], 0 < C4 < C5 < 3 C4,
  // and what it gains where it lengthens [s/rad].
  double rate_75 = 1.0, rate_50 = 2.0, lengthening = 0.0;
  double fastest = 1.0;  // kBell: the rate at which nothing is left [rad/s], > 0
  bool operator==(const StrengthCurve&) const = default;
};
inline auto MembersOf(const StrengthCurve& curve) {
  const auto& [form, torque, best_angle, width, rate_75, rate_50, lengthening, fastest] = curve;
  return std::tie(form, torque, best_angle, width, rate_75, rate_50, lengthening, fastest);
}

// A strength is never less than this share of `torque`, or a joint that moves fast could do nothing
// and any effort would be without bound.
inline constexpr double kLeastStrength = 0.05;

struct Strength {
  double torque = 0.0;       // [N m], > 0
  bool is_at_least = false;  // the model says less than kLeastStrength
};

// Of both directions of a hinge: it can give torques from -negative to positive.
struct StrengthLimits {
  Strength positive, negative;
};

struct JointStrength {
  StrengthCurve positive, negative;  // towards greater and lesser angles
  // At an angle [rad] and a rate [rad/s] of the hinge.
  StrengthLimits At(double angle, double rate) const;
  bool operator==(const JointStrength&) const = default;
};
inline auto MembersOf(const JointStrength& strength) {
  const auto& [positive, negative] = strength;
  return std::tie(positive, negative);
}

Strength StrengthAt(const StrengthCurve& curve, double angle, double shortening_rate);
// Returns the share of `torque` that the model says there, less kLeastStrength.
double ShareAboveLeast(const StrengthCurve& curve, double angle, double shortening_rate);

// The share of the torque at rest that is left at a rate [rad/s], positive where muscles shorten.
double StrengthOfRate(const StrengthCurve& curve, double shortening_rate);
// The share of `torque` at rest and at an angle [rad].
double StrengthOfAngle(const StrengthCurve& curve, double angle);

}  // namespace hazumi
