// Two joints that throw each other off their stops, at ever shorter intervals: there are infinitely
// many blows before they rest, more than a thousand before the last is lost to rounding.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/animations.h"
#include "tests/support/odd_figures.h"
#include "tests/support/released.h"

namespace hazumi::test {
namespace {

Animation KickingStops(double rate, int frames, Method method) {
  Animation animation =
      Released(StopsThatKickEachOther(), VecX::Zero(2), Eigen::Vector2d(rate, 0.0), frames, method);
  SetTolerance(&animation, 1e-6);
  return animation;
}

// The blows of small motions follow a geometric series; its sum, from the figure's inertias and
// the moments of its weights.
double RestTime(double rate) {
  const double M11 = 1e-4 + 0.1 * 0.015 * 0.015 + 0.03 + 0.01 * 0.01;
  const double M22 = 0.03 + 0.02 * 0.02, M12 = 0.03 - 0.01 * 0.02;
  const double G1 = 9.81 * (0.1 * 0.015 + 0.01), G2 = 9.81 * 0.02;
  const double second = rate * M12 / M22, first = second * M12 / M11;  // after a blow
  const double pair = 2.0 * second * M22 / G2 + 2.0 * first * M11 / G1;
  return pair / (1.0 - M12 * M12 / (M11 * M22));
}

TEST(Exact, ComesToRestAfterInfinitelyManyBlowsWithinAFewHundredEvents) {
  const Animation animation = KickingStops(0.02, 30, Method::kExact);
  const Motion motion = BakeFinite(animation);
  EXPECT_GT(motion.events.size(), 40u);
  EXPECT_LE(motion.events.size(), 400u);
  EXPECT_LE(motion.regions[0].evaluations, 40000);
  ASSERT_LT(RestTime(0.02), 0.9);
  const MotionFrame& end = motion.frames.back();
  EXPECT_LE(end.q.cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LE(end.before.qd.cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_NEAR(motion.events.back().time, RestTime(0.02), 0.05);
}

TEST(Exact, CountsTheBlowsRightWhileTheyAreFarApart) {
  const Animation animation = KickingStops(0.5, 30, Method::kExact);
  const Motion motion = BakeFinite(animation);
  // The start is a blow too; the second of the pair comes back after 2 v M22 / G2.
  const auto stops = EventsOf(motion, EventKind::kStop);
  ASSERT_GE(stops.size(), 3u);
  EXPECT_EQ(stops[0].joint, "first");
  EXPECT_EQ(stops[0].time, 0.0);
  EXPECT_EQ(stops[1].joint, "second");
  EXPECT_NEAR(stops[1].time, 2.0 * 0.5 * (0.03 - 0.0002) / (9.81 * 0.02), 0.005);
  EXPECT_LE(EnergyGain(animation, motion), 0.0);
}

// Whoever starts a frame beyond its stop is put back on it: the paper's step sees no blow at all.
TEST(Paper, RestsAtOnceWhereStopsKick) {
  const Motion motion = BakeFinite(KickingStops(0.02, 30, Method::kPaper));
  for (size_t f = 2; f < motion.frames.size(); ++f) {
    EXPECT_LE(motion.frames[f].q.cwiseAbs().maxCoeff(), 1e-12) << f;
  }
}

}  // namespace
}  // namespace hazumi::test
