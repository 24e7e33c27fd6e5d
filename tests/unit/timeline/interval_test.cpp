#include "engine/timeline/interval.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace hazumi {
namespace {

void ExpectSample(const CurveSample& sample, double value, double rate, double acceleration) {
  EXPECT_NEAR(sample.value, value, 1e-13);
  EXPECT_NEAR(sample.rate, rate, 1e-12);
  EXPECT_NEAR(sample.acceleration, acceleration, 1e-11);
}

TEST(Interval, HoldStays) { ExpectSample(Interval::Hold(0.7).At(123.0), 0.7, 0.0, 0.0); }

TEST(Interval, LinearRunsAtTheSlope) {
  const Interval interval = Interval::Linear(1.0, 2.5, 0.5);
  ExpectSample(interval.At(0.0), 1.0, 3.0, 0.0);
  ExpectSample(interval.At(0.5), 2.5, 3.0, 0.0);
}

// The rule: r2 = 2 (v2 - v1) / dt - r1.
TEST(Interval, QuadraticArrivesWithTwiceTheSlopeLessTheFirstRate) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-2.0, 2.0), time(0.1, 1.0);
  for (int i = 0; i < 50; ++i) {
    const double v1 = any(random), r1 = any(random), v2 = any(random), dt = time(random);
    const Interval interval = Interval::Quadratic(v1, r1, v2, dt);
    const double arrival = 2.0 * (v2 - v1) / dt - r1;
    ExpectSample(interval.At(0.0), v1, r1, (arrival - r1) / dt);
    ExpectSample(interval.At(dt), v2, arrival, (arrival - r1) / dt);
  }
}

TEST(Interval, CubicMeetsBothValuesAndRates) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-2.0, 2.0), time(0.1, 1.0);
  for (int i = 0; i < 50; ++i) {
    const double v1 = any(random), r1 = any(random), v2 = any(random), r2 = any(random);
    const double dt = time(random);
    const Interval interval = Interval::Cubic(v1, r1, v2, r2, dt);
    EXPECT_EQ(interval.At(0.0).value, v1);
    EXPECT_EQ(interval.At(0.0).rate, r1);
    EXPECT_NEAR(interval.At(dt).value, v2, 1e-13);
    EXPECT_NEAR(interval.At(dt).rate, r2, 1e-12);
  }
}

TEST(AutomaticRate, IsZeroAtExtremesAndBesideLevelStretches) {
  EXPECT_EQ(AutomaticRate(0.0, 0.0, 1.0, 2.0, 2.0, 1.0), 0.0);
  EXPECT_EQ(AutomaticRate(0.0, 0.0, 1.0, -2.0, 2.0, 1.0), 0.0);
  EXPECT_EQ(AutomaticRate(0.0, 1.0, 1.0, 1.0, 2.0, 3.0), 0.0);
  EXPECT_EQ(AutomaticRate(0.0, 1.0, 1.0, 3.0, 2.0, 3.0), 0.0);
}

TEST(AutomaticRate, IsTheParabolasSlopeWhereThatDoesNotOvershoot) {
  const auto f = [](double t) { return 1.0 + 2.0 * t + 0.3 * t * t; };
  EXPECT_NEAR(AutomaticRate(0.5, f(0.5), 1.0, f(1.0), 2.5, f(2.5)), 2.0 + 0.6, 1e-12);
}

TEST(AutomaticRate, NeverMakesACubicOvershoot) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> rise(0.0, 1.0), time(0.05, 1.0);
  for (int i = 0; i < 200; ++i) {
    double t[4] = {0.0}, v[4] = {0.0};
    for (int k = 1; k < 4; ++k) {
      t[k] = t[k - 1] + time(random);
      v[k] = v[k - 1] + rise(random) * rise(random) * rise(random);
    }
    const double r1 = AutomaticRate(t[0], v[0], t[1], v[1], t[2], v[2]);
    const double r2 = AutomaticRate(t[1], v[1], t[2], v[2], t[3], v[3]);
    const Interval interval = Interval::Cubic(v[1], r1, v[2], r2, t[2] - t[1]);
    for (int s = 0; s <= 100; ++s) {
      EXPECT_GE(interval.At((t[2] - t[1]) * s / 100.0).rate, -1e-12) << "curve " << i;
    }
  }
}

}  // namespace
}  // namespace hazumi
