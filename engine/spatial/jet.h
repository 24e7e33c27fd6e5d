#pragma once

#include <Eigen/Core>
#include <cmath>
#include <tuple>

namespace hazumi {

// A function of time at one instant: its value and its first two time derivatives (per second).
// Arithmetic on jets differentiates exactly.
struct Jet {
  double v = 0.0, d = 0.0, dd = 0.0;

  Jet() = default;
  Jet(double value) : v(value) {}  // NOLINT: a constant is a jet
  Jet(double value, double rate, double acceleration) : v(value), d(rate), dd(acceleration) {}

  Jet& operator+=(const Jet& b) { return *this = Jet(v + b.v, d + b.d, dd + b.dd); }
  Jet& operator-=(const Jet& b) { return *this = Jet(v - b.v, d - b.d, dd - b.dd); }
  Jet& operator*=(const Jet& b) {
    return *this = Jet(v * b.v, d * b.v + v * b.d, dd * b.v + 2.0 * d * b.d + v * b.dd);
  }
  friend Jet operator+(Jet a, const Jet& b) { return a += b; }
  friend Jet operator-(Jet a, const Jet& b) { return a -= b; }
  friend Jet operator*(Jet a, const Jet& b) { return a *= b; }
  friend Jet operator-(const Jet& a) { return {-a.v, -a.d, -a.dd}; }
  friend bool operator==(const Jet&, const Jet&) = default;
};

inline Jet sin(const Jet& x) {
  const double s = std::sin(x.v), c = std::cos(x.v);
  return {s, c * x.d, c * x.dd - s * x.d * x.d};
}
inline Jet cos(const Jet& x) {
  const double s = std::sin(x.v), c = std::cos(x.v);
  return {c, -s * x.d, -s * x.dd - c * x.d * x.d};
}

inline auto MembersOf(const Jet& x) {
  const auto& [v, d, dd] = x;
  return std::tie(v, d, dd);
}

}  // namespace hazumi

template <>
struct Eigen::NumTraits<hazumi::Jet> : Eigen::NumTraits<double> {
  using Real = hazumi::Jet;
  using NonInteger = hazumi::Jet;
  using Nested = hazumi::Jet;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 3,
    AddCost = 3,
    MulCost = 9
  };
};
