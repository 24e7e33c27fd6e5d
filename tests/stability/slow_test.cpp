// The longest swing and the longest chain.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <ctime>

#include "tests/support/arm7_cases.h"
#include "tests/support/odd_figures.h"
#include "tests/support/passive_swing.h"

namespace hazumi::test {
namespace {

constexpr double kRadian = 57.295779513082320877;  // in degrees

// A tenth of the tolerance of 1e-8 for each step, as the bake gives it.
TEST(Exact, KeepsTheEnergyOfAFreeSwingForTenMinutes) {
  const Figure arm = FreeArm7();
  const Course course =
      SwingExactly({arm, FreeSwing().start_deg / kRadian, FreeSwing().start_rate, 600.0}, 1e-9);
  EXPECT_TRUE(course.finished);
  EXPECT_LE(course.energy_drift, 1e-6);
}

// Let go level; how long it takes is printed with the evaluations that it takes.
TEST(Exact, LetsAThousandLinksFallForASecondWithinAMinuteOfComputing) {
  const Figure chain = Chain(1000);
  VecX q = VecX::Zero(1000);
  q[0] = -std::acos(0.0);
  const std::clock_t start = std::clock();
  const Course course = SwingExactly({chain, q, VecX::Zero(1000), 1.0}, 1e-4);
  EXPECT_TRUE(course.finished);
  EXPECT_LE(course.energy_drift, 1e-4);
  const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  std::printf("%ld evaluations, %.1f s\n", course.evaluations, seconds);
  EXPECT_LE(seconds, 60.0);
}

}  // namespace
}  // namespace hazumi::test
