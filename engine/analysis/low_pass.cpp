// Butterworth's filter of the second order, forwards and then backwards, so that phases cancel:
//   K = tan(pi f dt),   d = 1 + sqrt(2) K + K^2
//   y_n = (K^2 (x_n + 2 x_(n-1) + x_(n-2)) - 2 (K^2 - 1) y_(n-1) - (1 - sqrt(2) K + K^2) y_(n-2)) /
//   d
// Two passes halve the power where one takes it to sqrt(1/2), so each has the cutoff
//   f = cutoff / (sqrt(2) - 1)^(1/4)
// [Winter 2009]. Before the first sample and behind the last one a series goes on turned about that
// sample, 2 x_0 - x_n, so that value and slope do.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/analysis/smooth_motion.h"
#include "engine/spatial/lanes/lane_array.h"

namespace hazumi {

namespace {

LowPassFilter FilterFor(double radians) {
  const double K = std::tan(radians), d = 1.0 + std::numbers::sqrt2 * K + K * K;
  return {K * K / d, 2.0 * (K * K - 1.0) / d, (1.0 - std::numbers::sqrt2 * K + K * K) / d};
}

// Rows of a series from `first` on, at most kFiltered. `numbers`: room for them with what goes on
// before and behind.
template <int Rows>
void FilterRows(Eigen::Index first, Eigen::Index rows, Eigen::Index pad,
                const LowPassFilter& filter, const EffortKernels& kernels, MatX* series,
                LaneArray* numbers) {
  const Eigen::Index n = series->cols(), count = n + 2 * pad;
  Eigen::Map<Eigen::Matrix<double, kFiltered, Eigen::Dynamic>> longer(numbers->data(), kFiltered,
                                                                      count);
  auto given = series->middleRows<Rows>(first, rows);
  auto used = longer.topRows<Rows>(rows);
  for (Eigen::Index i = 0; i < n; ++i) used.col(pad + i) = given.col(i);
  for (Eigen::Index i = 1; i <= pad; ++i) {
    used.col(pad - i) = 2.0 * given.col(0) - given.col(i);
    used.col(pad + n - 1 + i) = 2.0 * given.col(n - 1) - given.col(n - 1 - i);
  }
  kernels.low_pass(filter, count, numbers->data());
  for (Eigen::Index i = 0; i < n; ++i) given.col(i) = used.col(pad + i);
}

}  // namespace

void LowPass(double cutoff, double dt, MatX* series, const EffortKernels& kernels) {
  const Eigen::Index n = series->cols();
  const double each = cutoff / std::pow(std::numbers::sqrt2 - 1.0, 0.25);
  if (n < 2 || each * dt >= 0.5) return;
  // Until a step has died away.
  const auto settling = static_cast<Eigen::Index>(std::ceil(1.5 / (each * dt)));
  const Eigen::Index pad = std::min(n - 1, settling);
  const LowPassFilter filter = FilterFor(std::numbers::pi * each * dt);
  LaneArray numbers(static_cast<size_t>(kFiltered * (n + 2 * pad)));
  Eigen::Index first = 0;
  for (; first + kFiltered <= series->rows(); first += kFiltered) {
    FilterRows<kFiltered>(first, kFiltered, pad, filter, kernels, series, &numbers);
  }
  if (first == series->rows()) return;
  FilterRows<Eigen::Dynamic>(first, series->rows() - first, pad, filter, kernels, series, &numbers);
}

}  // namespace hazumi
