#include "engine/analysis/hills.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/random.h"

namespace hazumi::test {
namespace {

constexpr Heights kHeights = {0.02, 0.03};

// Up, down and level in turn, with steps that a foot may have.
std::vector<double> RandomClearance(Random* random) {
  std::vector<double> clearance = {0.0};
  const int stretches = random->Integer(1, 8);
  for (int k = 0; k < stretches; ++k) {
    const double rate = random->Chance(0.4) ? 0.0 : random->Uniform(-0.02, 0.02);
    for (int i = random->Integer(1, 15); i > 0; --i) {
      const double noise = random->Uniform(-0.001, 0.001);
      clearance.push_back(std::max(0.0, clearance.back() + rate + noise));
    }
  }
  if (random->Chance(0.5)) clearance.push_back(0.0);
  return clearance;
}

TEST(Hills, AFootIsBetweenItsPeakAndItsValley) {
  Random random(1);
  int count = 0;
  for (int i = 0; i < 20'000; ++i) {
    const std::vector<double> clearance = RandomClearance(&random);
    for (const Hill& hill : HillsOf(clearance, kHeights)) {
      const Edge left = EdgeOf(clearance, hill.peak, hill.left, -1, kHeights);
      const Edge right = EdgeOf(clearance, hill.peak, hill.right, 1, kHeights);
      for (const double at : {left.at, left.touch}) {
        ASSERT_TRUE(at >= hill.left && at <= hill.peak) << "curve " << i << ": " << at;
      }
      for (const double at : {right.at, right.touch}) {
        ASSERT_TRUE(at >= hill.peak && at <= hill.right) << "curve " << i << ": " << at;
      }
      ++count;
    }
  }
  EXPECT_GT(count, 10'000);
}

// A foot that is not lifted any more than what it stands on beside.
TEST(Hills, APeakNoHigherThanTheGroundBesideIsItsOwnFoot) {
  const std::vector<double> clearance = {0.0, 0.10, 0.11, 0.10, 0.10, 0.10};
  const Edge edge = EdgeOf(clearance, 2, 5, 1, kHeights);
  EXPECT_EQ(edge.at, 2.0);
  EXPECT_EQ(edge.touch, 2.0);
}

}  // namespace
}  // namespace hazumi::test
