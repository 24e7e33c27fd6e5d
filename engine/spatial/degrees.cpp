#include "engine/spatial/degrees.h"

#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

namespace hazumi {

double ShortestDegrees(double radians) {
  const double degrees = radians / kDegree;
  // A double has this many digits for certain; with two more it is itself.
  constexpr int kDigits = std::numeric_limits<double>::digits10;
  for (int digits = kDigits; digits < kDigits + 2; ++digits) {
    char text[32];
    const auto written = std::to_chars(std::begin(text), std::end(text), degrees,
                                       std::chars_format::general, digits);
    double rounded = 0.0;
    std::from_chars(std::begin(text), written.ptr, rounded);
    if (rounded * kDegree == radians) return rounded;
  }
  return degrees;
}

double NearestTurn(double angle, double to) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  return angle + kTurn * std::round((to - angle) / kTurn);
}

}  // namespace hazumi
