// Each kind is a curve f(u) that begins slowly, from f(0) = 0 to f(1) = 1:
//   sine         1 - cos(pi u / 2)
//   quintic      u^5
//   exponential  e(u) = (2^(10 u) - 1) / (2^10 - 1)
//   back         u^2 ((s + 1) u - s): it first draws back, by a tenth at s = 1.70158
//   bounce       1 - b(1 - u), b parabolas that touch 1 at u = 1/2.75, 2/2.75, 2.5/2.75, 1
//   elastic      e(u) cos(6 pi (1 - u))
// In: f(u). Out: 1 - f(1 - u). In and out: f(2 u) / 2, and 1 - f(2 - 2 u) / 2 from u = 1/2 on.
// [Penner, Motion, Tweening, and Easing, 2001; e begins at 0 here, so that no end jumps]

#include <array>
#include <cmath>
#include <numbers>

#include "engine/timeline/interval.h"

namespace hazumi {

namespace {

constexpr double kPi = std::numbers::pi;

Eased Exponential(double u) {
  constexpr double kRate = 10.0 * std::numbers::ln2, kWhole = 1023.0;
  const double power = std::exp2(10.0 * u);
  return {(power - 1.0) / kWhole, kRate * power / kWhole, kRate * kRate * power / kWhole};
}

Eased Back(double u) {
  constexpr double s = 1.70158;
  return {u * u * ((s + 1.0) * u - s), u * (3.0 * (s + 1.0) * u - 2.0 * s),
          6.0 * (s + 1.0) * u - 2.0 * s};
}

// A touch that has been reached is not one that comes.
constexpr double kSame = 1e-9;

// The bounces' ends and depths, from the first on.
constexpr double kBounceUnit = 2.75, kBounceSteepness = 7.5625;  // 2.75^2
constexpr std::array<double, 4> kBounceEnds = {1.0, 2.0, 2.5, 2.75};
constexpr std::array<double, 4> kBounceMiddles = {0.0, 1.5, 2.25, 2.625};
constexpr std::array<double, 4> kBounceLows = {0.0, 0.75, 0.9375, 0.984375};

Eased BounceDown(double u) {
  size_t i = 0;
  while (i + 1 < kBounceEnds.size() && u * kBounceUnit >= kBounceEnds[i]) ++i;
  const double from_middle = u - kBounceMiddles[i] / kBounceUnit;
  return {kBounceSteepness * from_middle * from_middle + kBounceLows[i],
          2.0 * kBounceSteepness * from_middle, 2.0 * kBounceSteepness};
}

// 1 - f(1 - u).
Eased Reversed(const Eased& at_rest) {
  return {1.0 - at_rest.value, at_rest.slope, -at_rest.curvature};
}

Eased Elastic(double u) {
  const Eased e = Exponential(u);
  constexpr double kTurn = 6.0 * kPi;
  const double phase = kTurn * (1.0 - u), c = std::cos(phase), s = std::sin(phase);
  return {e.value * c, e.slope * c + e.value * kTurn * s,
          e.curvature * c + 2.0 * e.slope * kTurn * s - e.value * kTurn * kTurn * c};
}

Eased In(Interpolation kind, double u) {
  switch (kind) {
    case Interpolation::kSine:
      return {1.0 - std::cos(0.5 * kPi * u), 0.5 * kPi * std::sin(0.5 * kPi * u),
              0.25 * kPi * kPi * std::cos(0.5 * kPi * u)};
    case Interpolation::kQuintic:
      return {u * u * u * u * u, 5.0 * u * u * u * u, 20.0 * u * u * u};
    case Interpolation::kExponential:
      return Exponential(u);
    case Interpolation::kBack:
      return Back(u);
    case Interpolation::kBounce:
      return Reversed(BounceDown(1.0 - u));
    case Interpolation::kElastic:
      return Elastic(u);
    default:
      return {u, 1.0, 0.0};
  }
}

Eased At(Interpolation kind, Easing easing, double u) {
  if (easing == Easing::kIn) return In(kind, u);
  // Of a bounce the side of a touch that counts is the later one.
  if (kind == Interpolation::kBounce && easing == Easing::kOut) return BounceDown(u);
  if (easing == Easing::kOut) return Reversed(In(kind, 1.0 - u));
  const Eased half =
      u < 0.5 ? At(kind, Easing::kIn, 2.0 * u) : At(kind, Easing::kOut, 2.0 * u - 1.0);
  return {0.5 * half.value + (u < 0.5 ? 0.0 : 0.5), half.slope, 2.0 * half.curvature};
}

double SmoothUntilIn(Interpolation kind, Easing easing, double from) {
  if (kind != Interpolation::kBounce) return 1.0;
  double until = 1.0;
  for (const double end : kBounceEnds) {
    const double touch = easing == Easing::kIn ? 1.0 - end / kBounceUnit : end / kBounceUnit;
    if (touch > from + kSame && touch < until) until = touch;
  }
  return until;
}

}  // namespace

Eased Ease(Interpolation kind, Easing easing, double u) {
  Eased at = At(kind, easing, u);
  if (u <= 0.0) at.value = 0.0;
  if (u >= 1.0) at.value = 1.0;
  return at;
}

double SmoothUntil(Interpolation kind, Easing easing, double from) {
  if (easing != Easing::kInOut) return SmoothUntilIn(kind, easing, from);
  return from < 0.5 - kSame ? 0.5 * SmoothUntilIn(kind, Easing::kIn, 2.0 * from)
                            : 0.5 + 0.5 * SmoothUntilIn(kind, Easing::kOut, 2.0 * from - 1.0);
}

}  // namespace hazumi
