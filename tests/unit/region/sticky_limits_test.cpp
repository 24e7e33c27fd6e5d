#include "engine/region/exact/sticky_limits.h"

#include <gtest/gtest.h>

#include "engine/region/exact/limit_range.h"

namespace hazumi {
namespace {

constexpr int kHinges = 40;

// Limits that every hinge meets once within 1/30 s, each an event; the first hinge comes back
// `count` more times.
StickyLimits After(int count, int version) {
  StickyLimits limits(SolverRules(version), kHinges);
  limits.Begin();
  double t = 0.0;
  const auto arrive = [&](int hinge) {
    limits.CountEvent(t += 1e-4);
    limits.CountArrival(hinge, t);
  };
  for (int i = 0; i < kHinges; ++i) arrive(i);
  for (int i = 0; i < count; ++i) arrive(0);
  limits.CountEvent(t);
  return limits;
}

TEST(StickyLimits, HingesThatPassStayAsTheyAre) {
  const StickyLimits limits = After(0, 2);
  for (int i = 0; i < kHinges; ++i) EXPECT_EQ(limits.distance(i), kTouch) << i;
}

TEST(StickyLimits, OnlyTheHingeThatComesBackSticks) {
  const StickyLimits limits = After(9, 2);
  EXPECT_EQ(limits.distance(0), kTouch * 64.0);  // 10 times, 6 more than 4
  EXPECT_EQ(limits.rest_rate(0), 64.0 * StickyLimits::least_rest_rate());
  for (int i = 1; i < kHinges; ++i) EXPECT_EQ(limits.distance(i), kTouch) << i;
}

TEST(StickyLimits, HaveAMost) { EXPECT_EQ(After(200, 2).distance(0), kTouch * 1048576.0); }

TEST(StickyLimits, AreAsBeforeOnceTheHitsAreLongAgo) {
  StickyLimits limits = After(9, 2);
  limits.CountEvent(1.0);
  EXPECT_EQ(limits.distance(0), kTouch);
  EXPECT_EQ(limits.RecentEvents(1.0), 1);
}

// The 41st event in a row is 17 more than 24.
TEST(StickyLimits, AllHingesStickInVersionOne) {
  const StickyLimits limits = After(0, 1);
  for (int i = 0; i < kHinges; ++i) EXPECT_EQ(limits.distance(i), kTouch * 131072.0) << i;
}

}  // namespace
}  // namespace hazumi
