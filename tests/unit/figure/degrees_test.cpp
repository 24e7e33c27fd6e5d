#include "engine/spatial/degrees.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/random.h"

namespace hazumi::test {
namespace {

TEST(Degrees, WhatIsReadWithUpToFiveDecimalsIsWrittenSo) {
  for (int i = -3'600'000; i <= 3'600'000; i += 7) {
    const double degrees = i / 1e5;
    ASSERT_EQ(ShortestDegrees(degrees * kDegree), degrees);
  }
  EXPECT_EQ(ShortestDegrees(15.0 * kDegree), 15.0);
}

TEST(Degrees, AreTheSameRadiansAgain) {
  Random random(1);
  int unlike = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double radians = random.Uniform(-7.0, 7.0);
    const double again = ShortestDegrees(radians) * kDegree;
    unlike += again != radians;
    ASSERT_NEAR(again, radians, std::numeric_limits<double>::epsilon() * std::abs(radians));
  }
  EXPECT_LT(unlike, 12'000);  // some are no number of degrees
}

}  // namespace
}  // namespace hazumi::test
