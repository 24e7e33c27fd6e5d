// Butterworth's filter of the second order, forwards and then backwards, so that phases cancel:
//   K = tan(pi f dt),   d = 1 + sqrt(2) K + K^2
//   y_n = (K^2 (x_n + 2 x_(n-1) + x_(n-2)) - 2 (K^2 - 1) y_(n-1) - (1 - sqrt(2) K + K^2) y_(n-2)) /
//   d
// Two passes halve the power where one takes it to sqrt(1/2), so each has the cutoff
//   f = cutoff / (sqrt(2) - 1)^(1/4)
// [Winter 2009]. Before the first sample and behind the last one a series goes on turned about that
// sample, 2 x_0 - x_n, so that value and slope do.

#include "engine/analysis/low_pass.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hazumi {

namespace {

struct Filter {
  explicit Filter(double radians) {
    const double K = std::tan(radians), d = 1.0 + std::numbers::sqrt2 * K + K * K;
    b = K * K / d;
    a1 = 2.0 * (K * K - 1.0) / d;
    a2 = (1.0 - std::numbers::sqrt2 * K + K * K) / d;
  }
  double b, a1, a2;
};

// In the order of column(0), column(1), ..., from rest at the first one.
template <typename ColumnOf>
void Pass(const Filter& filter, Eigen::Index count, ColumnOf column) {
  VecX x1 = column(0), x2 = x1, y1 = x1, y2 = x1, y;
  for (Eigen::Index n = 1; n < count; ++n) {
    const VecX x = column(n);
    y = filter.b * (x + 2.0 * x1 + x2) - filter.a1 * y1 - filter.a2 * y2;
    column(n) = y;
    x2.swap(x1);
    x1 = x;
    y2.swap(y1);
    y1.swap(y);
  }
}

}  // namespace

void LowPass(double cutoff, double dt, MatX* series) {
  const Eigen::Index n = series->cols();
  const double each = cutoff / std::pow(std::numbers::sqrt2 - 1.0, 0.25);
  if (n < 2 || each * dt >= 0.5) return;
  // Until a step has died away.
  const auto settling = static_cast<Eigen::Index>(std::ceil(1.5 / (each * dt)));
  const Eigen::Index pad = std::min(n - 1, settling);
  MatX longer(series->rows(), n + 2 * pad);
  longer.middleCols(pad, n) = *series;
  for (Eigen::Index i = 1; i <= pad; ++i) {
    longer.col(pad - i) = 2.0 * series->col(0) - series->col(i);
    longer.col(pad + n - 1 + i) = 2.0 * series->col(n - 1) - series->col(n - 1 - i);
  }
  const Filter filter(std::numbers::pi * each * dt);
  const Eigen::Index count = longer.cols();
  Pass(filter, count, [&](Eigen::Index i) { return longer.col(i); });
  Pass(filter, count, [&](Eigen::Index i) { return longer.col(count - 1 - i); });
  *series = longer.middleCols(pad, n);
}

}  // namespace hazumi
