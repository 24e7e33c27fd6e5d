#pragma once

#include <array>
#include <variant>

#include "engine/timeline/keyframe.h"

namespace hazumi {

// A curve's value and its first and second time derivatives (per second).
struct CurveSample {
  double value = 0.0;
  double rate = 0.0;
  double acceleration = 0.0;
};

// How a curve runs from key to key, in the seconds since its start: a polynomial of degree three at
// most [Arai 2.5] or of degree five, an eased way, or a cubic whose tangents are longer or shorter
// than a third.
class Interval {
 public:
  static Interval Hold(double value);
  static Interval Linear(double v1, double v2, double duration);
  // From v1 with rate r1 to v2; arrives with the rate 2 (v2 - v1) / duration - r1.
  static Interval Quadratic(double v1, double r1, double v2, double duration);
  static Interval Cubic(double v1, double r1, double v2, double r2, double duration);
  // Polynomial of degree five between two values with their rates and accelerations.
  static Interval Quintic(const CurveSample& from, const CurveSample& to, double duration);
  static Interval Eased(double v1, double v2, double duration, Interpolation kind, Easing easing);
  // Both lengths in (0, 1): shares of the duration. The value and the time are cubics of a
  // parameter [Bezier]; with lengths of a third it is Cubic.
  static Interval Weighted(double v1, double r1, double length1, double v2, double r2,
                           double length2, double duration);

  CurveSample At(double seconds) const;
  // True for a polynomial of degree three at most.
  bool is_polynomial() const { return std::holds_alternative<Polynomial>(way_); }
  // Of a polynomial: c[i] goes with the power i of the seconds.
  std::array<double, 4> coefficients() const { return std::get<Polynomial>(way_).c; }
  // Up to when after `seconds` it is smooth; a polynomial is so without end.
  double SmoothUntil(double seconds) const;
  bool operator==(const Interval&) const = default;

 private:
  struct Polynomial {
    std::array<double, 4> c;
    bool operator==(const Polynomial&) const = default;
  };
  struct QuinticWay {
    std::array<double, 6> c;
    bool operator==(const QuinticWay&) const = default;
  };
  struct EasedWay {
    double v1, v2, duration;
    Interpolation kind;
    Easing easing;
    CurveSample At(double seconds) const;
    bool operator==(const EasedWay&) const = default;
  };
  struct WeightedWay {
    std::array<double, 4> values;  // of the four points
    double first, second;          // when the two in the middle are, as shares of the duration
    double duration;
    CurveSample At(double seconds) const;
    bool operator==(const WeightedWay&) const = default;
  };
  std::variant<Polynomial, QuinticWay, EasedWay, WeightedWay> way_;
};

// Rate of an automatic tangent at (t, v) between its neighbours: the slope of the parabola through
// the three points, zero where v is not strictly between its neighbours, and never steeper than
// three times the flatter side, so that the cubic does not overshoot [Fritsch, Carlson 1980].
double AutomaticRate(double t_left, double v_left, double t, double v, double t_right,
                     double v_right);

// A way from 0 to 1 in the time u from 0 to 1, with its first and second derivatives by u.
struct Eased {
  double value = 0.0, slope = 0.0, curvature = 0.0;
};

// For an eased `kind`. Exactly 0 and 1 at the ends, and their limits from inside there.
Eased Ease(Interpolation kind, Easing easing, double u);

// Up to which u > `from` the way is smooth: where it bounces, where its two halves meet, or 1.
double SmoothUntil(Interpolation kind, Easing easing, double from);

}  // namespace hazumi
