// Two joints that throw each other off their limits, at ever shorter intervals: there are
// infinitely many impacts before they rest, more than a thousand before the last is lost to
// rounding.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "engine/region/exact/exact_solver.h"
#include "tests/support/animations.h"
#include "tests/support/figures.h"
#include "tests/support/odd_figures.h"
#include "tests/support/released.h"

namespace hazumi::test {
namespace {

Animation KickingLimits(double rate, int frames, Method method) {
  Animation animation = Released(LimitsThatKickEachOther(), VecX::Zero(2),
                                 Eigen::Vector2d(rate, 0.0), frames, method);
  SetTolerance(&animation, 1e-6);
  return animation;
}

// The impacts of small motions follow a geometric series; its sum, from the figure's inertias and
// the moments of its weights.
double RestTime(double rate) {
  const double M11 = 1e-4 + 0.1 * 0.015 * 0.015 + 0.03 + 0.01 * 0.01;
  const double M22 = 0.03 + 0.02 * 0.02, M12 = 0.03 - 0.01 * 0.02;
  const double G1 = 9.81 * (0.1 * 0.015 + 0.01), G2 = 9.81 * 0.02;
  const double second = rate * M12 / M22, first = second * M12 / M11;  // after an impulse
  const double pair = 2.0 * second * M22 / G2 + 2.0 * first * M11 / G1;
  return pair / (1.0 - M12 * M12 / (M11 * M22));
}

long HitsOf(const Motion& motion) {
  long hits = 0;
  for (const MotionEvent& event : EventsOf(motion, EventKind::kLimit)) hits += event.count;
  return hits;
}

TEST(Exact, ComesToRestAfterInfinitelyManyBlowsWithinAFewHundredEvents) {
  const Animation animation = KickingLimits(0.02, 30, Method::kExact);
  const Motion motion = BakeFinite(animation);
  EXPECT_GT(HitsOf(motion), 40);
  EXPECT_LE(HitsOf(motion), 400);
  EXPECT_LE(motion.regions[0].evaluations, 40000);
  ASSERT_LT(RestTime(0.02), 0.9);
  const MotionFrame& end = motion.frames.back();
  EXPECT_LE(end.q.cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LE(end.before.qd.cwiseAbs().maxCoeff(), 1e-12);
  double last = 0.0;
  for (const MotionEvent& event : motion.events) last = std::max(last, event.last_time);
  EXPECT_NEAR(last, RestTime(0.02), 0.05);
}

TEST(Exact, CountsTheBlowsRightWhileTheyAreFarApart) {
  const Animation animation = KickingLimits(0.5, 30, Method::kExact);
  const Motion motion = BakeFinite(animation);
  // The start is an impulse too; the second of the pair comes back after 2 v M22 / G2.
  const auto limits = EventsOf(motion, EventKind::kLimit);
  ASSERT_GE(limits.size(), 3u);
  EXPECT_EQ(limits[0].joint, "first");
  EXPECT_EQ(limits[0].time, 0.0);
  EXPECT_EQ(limits[1].joint, "second");
  EXPECT_NEAR(limits[1].time, 2.0 * 0.5 * (0.03 - 0.0002) / (9.81 * 0.02), 0.005);
  EXPECT_LE(EnergyGain(animation, motion), 0.0);
}

// Three rods in line, pressed on their limits by a base that turns to and fro.
Figure PressedRods() {
  struct Rod {
    Vec3 offset, to;
    double upper, mass;
  };
  const Rod rods[] = {
      {{0.0, 0.0, 0.0}, {0.0298, 0.0, 0.2589}, 0.05, 4.864},
      {{-0.00915, 0.0, -0.0388}, {-0.1772, 0.0, -0.2073}, 0.033, 0.664},
      {{-0.228, 0.0, 0.0716}, {0.0727, 0.0, 0.0796}, 0.0267, 1.726},
  };
  FigureSpec spec;
  spec.name = "pressed";
  spec.root_name = "base";
  for (const Rod& rod : rods) {
    JointSpec joint;
    joint.name = "j" + std::to_string(spec.joints.size());
    joint.parent = spec.joints.empty() ? spec.root_name : spec.joints.back().name;
    joint.offset = rod.offset;
    joint.hinges = {{"", Vec3::UnitY(), 0.0, rod.upper, 0.0}};
    LinkSpec link;
    link.name = joint.name;
    link.to = rod.to;
    link.radius = 0.02;
    link.mass = rod.mass;
    joint.links = {link};
    spec.joints.push_back(joint);
  }
  return Build(spec);
}

Animation PressedInTurn() {
  Animation animation =
      Released(PressedRods(), VecX::Zero(3), Vec3(0.0583, 0.366, -0.731), 30, Method::kExact);
  double frame = 0.0;
  for (const double degrees :
       {0.0, 284.0, 2218.0, 3630.0, 1593.0, 6579.0, 5049.0, 5330.0, 5020.0, 11739.0, 2727.0}) {
    animation.root_keys[kRootAngleY].push_back(
        {frame, degrees * std::numbers::pi / 180.0, std::nullopt, Interpolation::kCubic});
    frame += 3.0;
  }
  return animation;
}

// In version 1 of the solver the first two hit them fifty thousand times within 15 ms. With an
// account of energy step by step, without it all at once.
TEST(Exact, TellsOfLimitsThatArePressedInTurnByTheirNumberAndTime) {
  Animation animation = PressedInTurn();
  animation.solver.version = 1;
  for (const bool energy : {false, true}) {
    BakeOptions options;
    options.energy = energy;
    const Result<Motion> motion = Bake(animation, options);
    ASSERT_TRUE(motion.ok()) << motion.error().ToString();
    EXPECT_GT(HitsOf(motion.value()), 50000);
    EXPECT_LE(motion.value().events.size(), 40u);
    std::map<std::string, double> last;
    for (const MotionEvent& event : motion.value().events) {
      EXPECT_GE(event.last_time, event.time);
      EXPECT_EQ(event.count == 1, event.last_time == event.time) << event.joint;
      if (last.contains(event.joint)) {
        EXPECT_GE(event.time, last[event.joint] + kChatterGap);
      }
      last[event.joint] = event.last_time;
    }
  }
}

// Hinges that a hit pushes off a limit, and that would be back within 4e-10 rad, stay there.
TEST(Exact, RestsAtOnceOnLimitsThatArePressedInTurn) {
  const Result<Motion> motion = Bake(PressedInTurn());
  ASSERT_TRUE(motion.ok()) << motion.error().ToString();
  EXPECT_LT(HitsOf(motion.value()), 500);
}

// Whoever starts a frame beyond its limit is put back on it: the paper's step sees no impulse at
// all.
TEST(Paper, RestsAtOnceWhereLimitsKick) {
  const Motion motion = BakeFinite(KickingLimits(0.02, 30, Method::kPaper));
  for (size_t f = 2; f < motion.frames.size(); ++f) {
    EXPECT_LE(motion.frames[f].q.cwiseAbs().maxCoeff(), 1e-12) << f;
  }
}

}  // namespace
}  // namespace hazumi::test
