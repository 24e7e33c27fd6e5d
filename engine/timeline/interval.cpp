// A cubic with tangents of other lengths a and b is a Bezier curve in time and value: with the
// parameter p from 0 to 1 and the duration T,
//   t(p) = T [3 (1 - p)^2 p a + 3 (1 - p) p^2 (1 - b) + p^3]
//   v(p) = (1 - p)^3 v1 + 3 (1 - p)^2 p (v1 + r1 a T) + 3 (1 - p) p^2 (v2 - r2 b T) + p^3 v2.
// t grows with p for a, b in (0, 1), so that p is found by Newton's method inside a bracket. With '
// for d/dp the rate is v'/t' and the acceleration (v'' t' - v' t'') / t'^3.

#include "engine/timeline/interval.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hazumi {

namespace {

// A cubic by its four points, with its derivatives by the parameter.
struct Bezier {
  double at, d1, d2;
};
Bezier At(const std::array<double, 4>& x, double p) {
  const double q = 1.0 - p;
  const double a = x[1] - x[0], b = x[2] - x[1], c = x[3] - x[2];
  return {q * q * q * x[0] + 3.0 * q * p * (q * x[1] + p * x[2]) + p * p * p * x[3],
          3.0 * (q * q * a + 2.0 * q * p * b + p * p * c), 6.0 * (q * (b - a) + p * (c - b))};
}

// Where a growing cubic from 0 to 1 has the value u.
double ParameterAt(const std::array<double, 4>& x, double u) {
  double low = 0.0, high = 1.0, p = u;
  for (int i = 0; i < 64; ++i) {
    const Bezier at = At(x, p);
    const double error = at.at - u;
    if (std::abs(error) <= 1e-15) return p;
    (error > 0.0 ? high : low) = p;
    const double next = p - error / at.d1;
    const double to = next > low && next < high ? next : 0.5 * (low + high);
    if (to == p) return p;
    p = to;
  }
  return p;
}

}  // namespace

Interval Interval::Hold(double value) {
  Interval interval;
  interval.way_ = Polynomial{{value}};
  return interval;
}

Interval Interval::Linear(double v1, double v2, double duration) {
  Interval interval;
  interval.way_ = Polynomial{{v1, (v2 - v1) / duration}};
  return interval;
}

Interval Interval::Quadratic(double v1, double r1, double v2, double duration) {
  Interval interval;
  interval.way_ = Polynomial{{v1, r1, ((v2 - v1) / duration - r1) / duration}};
  return interval;
}

Interval Interval::Cubic(double v1, double r1, double v2, double r2, double duration) {
  const double slope = (v2 - v1) / duration;
  Interval interval;
  interval.way_ = Polynomial{{v1, r1, (3.0 * slope - 2.0 * r1 - r2) / duration,
                              (r1 + r2 - 2.0 * slope) / (duration * duration)}};
  return interval;
}

Interval Interval::Quintic(const CurveSample& from, const CurveSample& to, double duration) {
  const double T = duration, T2 = T * T, T3 = T2 * T;
  // Differences from the parabola of the first sample, at the end.
  const double value = to.value - from.value - from.rate * T - 0.5 * from.acceleration * T2;
  const double rate = to.rate - from.rate - from.acceleration * T;
  const double acceleration = to.acceleration - from.acceleration;
  Interval interval;
  interval.way_ =
      QuinticWay{{from.value, from.rate, 0.5 * from.acceleration,
                  (10.0 * value - 4.0 * rate * T + 0.5 * acceleration * T2) / T3,
                  (-15.0 * value + 7.0 * rate * T - acceleration * T2) / (T3 * T),
                  (6.0 * value - 3.0 * rate * T + 0.5 * acceleration * T2) / (T3 * T2)}};
  return interval;
}

Interval Interval::Eased(double v1, double v2, double duration, Interpolation kind, Easing easing) {
  Interval interval;
  interval.way_ = EasedWay{v1, v2, duration, kind, easing};
  return interval;
}

Interval Interval::Weighted(double v1, double r1, double length1, double v2, double r2,
                            double length2, double duration) {
  Interval interval;
  interval.way_ = WeightedWay{{v1, v1 + r1 * length1 * duration, v2 - r2 * length2 * duration, v2},
                              length1,
                              1.0 - length2,
                              duration};
  return interval;
}

CurveSample Interval::At(double s) const {
  if (const auto* polynomial = std::get_if<Polynomial>(&way_)) {
    const auto& [c0, c1, c2, c3] = polynomial->c;
    return {c0 + s * (c1 + s * (c2 + s * c3)), c1 + s * (2.0 * c2 + s * 3.0 * c3),
            2.0 * c2 + 6.0 * c3 * s};
  }
  if (const auto* quintic = std::get_if<QuinticWay>(&way_)) {
    const auto& [c0, c1, c2, c3, c4, c5] = quintic->c;
    return {c0 + s * (c1 + s * (c2 + s * (c3 + s * (c4 + s * c5)))),
            c1 + s * (2.0 * c2 + s * (3.0 * c3 + s * (4.0 * c4 + s * 5.0 * c5))),
            2.0 * c2 + s * (6.0 * c3 + s * (12.0 * c4 + s * 20.0 * c5))};
  }
  if (const auto* eased = std::get_if<EasedWay>(&way_)) return eased->At(s);
  return std::get<WeightedWay>(way_).At(s);
}

CurveSample Interval::EasedWay::At(double s) const {
  const hazumi::Eased at = Ease(kind, easing, s / duration);
  const double by = v2 - v1;
  return {at.value == 1.0 ? v2 : v1 + by * at.value, by * at.slope / duration,
          by * at.curvature / (duration * duration)};
}

CurveSample Interval::WeightedWay::At(double s) const {
  const std::array<double, 4> times = {0.0, first, second, 1.0};
  const double p = ParameterAt(times, std::clamp(s / duration, 0.0, 1.0));
  const Bezier t = hazumi::At(times, p), v = hazumi::At(values, p);
  return {v.at, v.d1 / (t.d1 * duration),
          (v.d2 * t.d1 - v.d1 * t.d2) / (t.d1 * t.d1 * t.d1 * duration * duration)};
}

double Interval::SmoothUntil(double seconds) const {
  const auto* eased = std::get_if<EasedWay>(&way_);
  if (!eased) return std::numeric_limits<double>::infinity();
  return eased->duration *
         hazumi::SmoothUntil(eased->kind, eased->easing, seconds / eased->duration);
}

double AutomaticRate(double t_left, double v_left, double t, double v, double t_right,
                     double v_right) {
  const double before = (v - v_left) / (t - t_left);
  const double after = (v_right - v) / (t_right - t);
  if (before * after <= 0.0) return 0.0;
  const double parabola = (before * (t_right - t) + after * (t - t_left)) / (t_right - t_left);
  const double limit = 3.0 * std::min(std::abs(before), std::abs(after));
  return std::clamp(parabola, -limit, limit);
}

}  // namespace hazumi
