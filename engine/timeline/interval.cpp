#include "engine/timeline/interval.h"

#include <algorithm>
#include <cmath>

namespace hazumi {

Interval Interval::Hold(double value) {
  Interval interval;
  interval.c0_ = value;
  return interval;
}

Interval Interval::Linear(double v1, double v2, double duration) {
  Interval interval;
  interval.c0_ = v1;
  interval.c1_ = (v2 - v1) / duration;
  return interval;
}

Interval Interval::Quadratic(double v1, double r1, double v2, double duration) {
  Interval interval;
  interval.c0_ = v1;
  interval.c1_ = r1;
  interval.c2_ = ((v2 - v1) / duration - r1) / duration;
  return interval;
}

Interval Interval::Cubic(double v1, double r1, double v2, double r2, double duration) {
  const double slope = (v2 - v1) / duration;
  Interval interval;
  interval.c0_ = v1;
  interval.c1_ = r1;
  interval.c2_ = (3.0 * slope - 2.0 * r1 - r2) / duration;
  interval.c3_ = (r1 + r2 - 2.0 * slope) / (duration * duration);
  return interval;
}

CurveSample Interval::At(double s) const {
  return {c0_ + s * (c1_ + s * (c2_ + s * c3_)), c1_ + s * (2.0 * c2_ + s * 3.0 * c3_),
          2.0 * c2_ + 6.0 * c3_ * s};
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
