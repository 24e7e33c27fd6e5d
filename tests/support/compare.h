#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/spatial/types.h"

namespace hazumi::test {

// Largest difference of any entry, as a fraction of the largest entry of `expected`. Not a number
// anywhere, or a difference in size, is infinitely wrong.
template <typename A, typename B>
double RelativeDifference(const Eigen::MatrixBase<A>& actual,
                          const Eigen::MatrixBase<B>& expected) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (actual.rows() != expected.rows() || actual.cols() != expected.cols()) return kInfinity;
  if (actual.size() == 0) return 0.0;
  const double difference = (actual - expected).cwiseAbs().maxCoeff();
  const double size = expected.cwiseAbs().maxCoeff();
  if (!(actual - expected).allFinite()) return kInfinity;
  return size > 0.0 ? difference / size : difference;
}

// The worst of many differences. Its decimal logarithm goes under the name of the claim into the
// test report (--gtest_output=xml).
class Worst {
 public:
  explicit Worst(const char* claim) : claim_(claim) {}
  ~Worst() { ::testing::Test::RecordProperty(claim_, std::to_string(std::log10(worst_))); }
  Worst(const Worst&) = delete;
  Worst& operator=(const Worst&) = delete;

  double operator()(double difference) {
    worst_ = std::max(worst_, difference);
    return difference;
  }
  double value() const { return worst_; }

 private:
  const char* claim_;
  double worst_ = 0.0;
};

}  // namespace hazumi::test
