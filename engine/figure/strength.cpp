// Strength at an angle q [rad] and a rate w [rad/s], w > 0 where the muscles shorten:
//   T(q, w) = torque * A(q) * V(w), at least kLeastStrength * torque.
//
// kCosine [Anderson, Madigan, Nussbaum 2007], which writes m g h C1 for `torque` and 1 / C2 for
// `width`, C3 for best_angle, C4, C5, C6 for rate_75, rate_50 and lengthening:
//   A = cos(C2 (q - C3)), 0 beyond a quarter of a turn of the cosine
//   V = (2 C4 C5 + w (C5 - 3 C4)) / (2 C4 C5 + w (2 C5 - 4 C4)),   w >= 0, never below 0
//   V = V(|w|) (1 - C6 w),                                        w < 0
// so that V(C4) = 3/4 and V(C5) = 1/2.
//
// kBell, s = w / fastest:
//   A = exp(-(q - best_angle)^2 / (2 width^2))
//   V = (1 - s) / (1 + 4 s), never below 0,                       s >= 0  [Hill 1938]
//   V = 1 - 0.4 s / (0.08 - s),                                   s < 0
// The last is ours: slope and value go on at rest, muscles that are stretched fast give 1.4 times
// what they give at rest.

#include "engine/figure/strength.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hazumi {

namespace {

double CosineOfRate(double c4, double c5, double w) {
  const double size = std::abs(w), both = 2.0 * c4 * c5;
  const double above = both + size * (c5 - 3.0 * c4);
  return above > 0.0 ? above / (both + size * (2.0 * c5 - 4.0 * c4)) : 0.0;
}

double HillOfRate(double s) {
  constexpr double kCurvature = 4.0, kGain = 0.4, kStretch = 0.08;
  return s >= 0.0 ? (1.0 - s) / (1.0 + kCurvature * s) : 1.0 - kGain * s / (kStretch - s);
}

}  // namespace

double StrengthOfRate(const StrengthCurve& curve, double w) {
  if (curve.form == StrengthCurve::Form::kConstant) return 1.0;
  if (curve.form == StrengthCurve::Form::kBell) return std::max(0.0, HillOfRate(w / curve.fastest));
  const double share = CosineOfRate(curve.rate_75, curve.rate_50, w);
  return w >= 0.0 ? share : share * (1.0 - curve.lengthening * w);
}

double StrengthOfAngle(const StrengthCurve& curve, double angle) {
  if (curve.form == StrengthCurve::Form::kConstant) return 1.0;
  const double x = (angle - curve.best_angle) / curve.width;
  if (curve.form == StrengthCurve::Form::kBell) return std::exp(-0.5 * x * x);
  return std::abs(x) < 0.5 * std::numbers::pi ? std::cos(x) : 0.0;
}

namespace {

// Of `torque`, as the model says.
double ShareAt(const StrengthCurve& curve, double angle, double shortening_rate) {
  return StrengthOfAngle(curve, angle) * StrengthOfRate(curve, shortening_rate);
}

}  // namespace

double ShareAboveLeast(const StrengthCurve& curve, double angle, double shortening_rate) {
  return ShareAt(curve, angle, shortening_rate) - kLeastStrength;
}

Strength StrengthAt(const StrengthCurve& curve, double angle, double shortening_rate) {
  const double share = ShareAt(curve, angle, shortening_rate);
  if (share >= kLeastStrength) return {curve.torque * share, false};
  return {curve.torque * kLeastStrength, true};
}

StrengthLimits JointStrength::At(double angle, double rate) const {
  return {StrengthAt(positive, angle, rate), StrengthAt(negative, angle, -rate)};
}

}  // namespace hazumi
