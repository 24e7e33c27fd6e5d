#pragma once

#include <cmath>

namespace hazumi::ui {

// 0 for what would be shown as "-0.0" with so many digits behind the point.
inline double WithoutMinusZero(double value, int digits) {
  return std::abs(value) < 0.5 * std::pow(10.0, -digits) ? 0.0 : value;
}

}  // namespace hazumi::ui
