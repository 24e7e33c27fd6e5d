#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>

#include "tests/support/random.h"

namespace hazumi::test {
namespace {

#include "engine/spatial/lanes/lane_trig.h"

// In units of the last place of `exact`.
double Error(double value, long double exact) {
  const double rounded = std::abs(static_cast<double>(exact));
  const double ulp = std::nextafter(rounded, 2.0) - rounded;
  return static_cast<double>(std::abs(value - exact) / ulp);
}

double WorstError(double angle) {
  double sine = 0.0, cosine = 0.0;
  SineAndCosine<1>(angle, &sine, &cosine);
  const auto x = static_cast<long double>(angle);
  return std::max(Error(sine, std::sin(x)), Error(cosine, std::cos(x)));
}

TEST(LaneTrig, IsWithinOneUnitOfTheLastPlace) {
  Random random(1);
  for (const double range : {1e-3, 1.0, 7.0, 1e3, kLargestAngle}) {
    for (int i = 0; i < 20000; ++i) {
      const double angle = random.Uniform(-range, range);
      ASSERT_LE(WorstError(angle), 1.0) << angle;
    }
  }
}

// Where sine or cosine is next to nothing, all of its digits come from the reduction.
TEST(LaneTrig, IsWithinOneUnitNextToMultiplesOfAQuarterTurn) {
  for (int n = -60000; n <= 60000; n += 7) {
    const double near = n * 1.57079632679489661923;
    for (const double angle : {near, std::nextafter(near, 1e9), std::nextafter(near, -1e9)}) {
      ASSERT_LE(WorstError(angle), 1.0) << n;
    }
  }
}

TEST(LaneTrig, OfZeroIsExact) {
  double sine = 1.0, cosine = 0.0;
  SineAndCosine<1>(0.0, &sine, &cosine);
  EXPECT_EQ(sine, 0.0);
  EXPECT_EQ(cosine, 1.0);
}

TEST(LaneTrig, LeavesLargeAnglesAndNonsenseToTheLibrary) {
  EXPECT_EQ(IsLarge<1>(0.999 * kLargestAngle), 0);
  EXPECT_EQ(IsLarge<1>(-0.999 * kLargestAngle), 0);
  EXPECT_NE(IsLarge<1>(1.001 * kLargestAngle), 0);
  EXPECT_NE(IsLarge<1>(-1.001 * kLargestAngle), 0);
  EXPECT_NE(IsLarge<1>(std::numeric_limits<double>::infinity()), 0);
  EXPECT_NE(IsLarge<1>(std::nan("")), 0);
}

}  // namespace
}  // namespace hazumi::test
