#pragma once

#include <array>
#include <tuple>

#include "engine/spatial/jet.h"

namespace hazumi {

// A coordinate that something else moves, in one smooth stretch of time: a polynomial in the
// seconds since `start` [rad or m].
struct DrivenCurve {
  static constexpr int kMaxDegree = 9;

  double start = 0.0;  // [s]
  int degree = 0;
  std::array<double, kMaxDegree + 1> c{};  // c[i] goes with the power i

  static DrivenCurve Constant(double value) {
    DrivenCurve curve;
    curve.c[0] = value;
    return curve;
  }

  Jet At(double seconds) const {
    if (degree == 0) return Jet(c[0]);
    const double s = seconds - start;
    double value = 0.0, rate = 0.0, half_acceleration = 0.0;
    for (int i = degree; i >= 0; --i) {
      half_acceleration = half_acceleration * s + rate;
      rate = rate * s + value;
      value = value * s + c[i];
    }
    return {value, rate, 2.0 * half_acceleration};
  }
};
inline auto MembersOf(const DrivenCurve& curve) {
  const auto& [start, degree, c] = curve;
  return std::tie(start, degree, c);
}

}  // namespace hazumi
