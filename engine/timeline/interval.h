#pragma once

#include <array>

namespace hazumi {

// A curve's value and its first and second time derivatives (per second).
struct CurveSample {
  double value = 0.0;
  double rate = 0.0;
  double acceleration = 0.0;
};

// A polynomial of degree three at most in the seconds since its start. [Arai 2.5]
class Interval {
 public:
  static Interval Hold(double value);
  static Interval Linear(double v1, double v2, double duration);
  // From v1 with rate r1 to v2; arrives with the rate 2 (v2 - v1) / duration - r1.
  static Interval Quadratic(double v1, double r1, double v2, double duration);
  static Interval Cubic(double v1, double r1, double v2, double r2, double duration);

  CurveSample At(double seconds) const;
  // c[i] goes with the power i of the seconds.
  std::array<double, 4> coefficients() const { return {c0_, c1_, c2_, c3_}; }
  bool operator==(const Interval&) const = default;

 private:
  double c0_ = 0.0, c1_ = 0.0, c2_ = 0.0, c3_ = 0.0;
};

// Rate of an automatic tangent at (t, v) between its neighbours: the slope of the parabola through
// the three points, zero where v is not strictly between its neighbours, and never steeper than
// three times the flatter side, so that the cubic does not overshoot [Fritsch, Carlson 1980].
double AutomaticRate(double t_left, double v_left, double t, double v, double t_right,
                     double v_right);

}  // namespace hazumi
