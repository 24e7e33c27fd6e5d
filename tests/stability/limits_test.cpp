// Many joints at their limits, limits without room, limits hit together.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/animations.h"
#include "tests/support/dense_dynamics.h"
#include "tests/support/odd_figures.h"
#include "tests/support/passive_swing.h"
#include "tests/support/random.h"
#include "tests/support/released.h"

namespace hazumi::test {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const VecX kAtRest = VecX::Zero(7);

// The arm with a limit on one side of each joint where it is: above where `upper_at` is positive,
// below where it is negative.
Figure ArmOnLimits(const VecX& upper_at) {
  VecX lower = VecX::Constant(7, -kInfinity), upper = -lower;
  for (int j = 0; j < 7; ++j) (upper_at[j] > 0.0 ? upper : lower)[j] = BentArm()[j];
  return Arm7Within(lower, upper);
}

// What gravity turns the joints of the resting arm with [N m], and how they would go [rad/s^2].
VecX Weights() {
  const Figure arm = FreeArm7();
  DynamicsWorkspace ws(arm);
  RootMotion root;
  root.a.z() = kG;
  ComputePositions(arm, Pose(), BentArm(), &ws);
  InverseDynamics(arm, root, kAtRest, kAtRest, nullptr, &ws);
  return -ws.tau;
}

VecX FreeAccelerations() {
  const Figure arm = FreeArm7();
  DynamicsWorkspace ws(arm);
  RootMotion root;
  root.a.z() = kG;
  ComputePositions(arm, Pose(), BentArm(), &ws);
  VecX qdd(7);
  EXPECT_FALSE(ForwardDynamics(arm, root, kAtRest, kAtRest, nullptr, &ws, &qdd));
  return qdd;
}

TEST(BothMethods, HoldAnArmAllOfWhoseJointsAreOnTheirLimits) {
  for (const Method method : {Method::kExact, Method::kPaper}) {
    const Animation animation = Released(ArmOnLimits(Weights()), BentArm(), kAtRest, 30, method);
    const Motion motion = BakeFinite(animation);
    for (const MotionFrame& frame : motion.frames) {
      EXPECT_LE((frame.q - BentArm()).cwiseAbs().maxCoeff(), 1e-12) << NameOf(method);
    }
    EXPECT_LE(motion.regions[0].evaluations, 200) << NameOf(method);
  }
}

TEST(Exact, LetsGoOfAllLimitsThatWouldHaveToPull) {
  const Release held{ArmOnLimits(-FreeAccelerations()), BentArm(), kAtRest, 0.05};
  const Release free{FreeArm7(), BentArm(), kAtRest, 0.05};
  const VecX difference = SwingExactly(held, 1e-9).q - SwingExactly(free, 1e-9).q;
  EXPECT_LE(difference.cwiseAbs().maxCoeff(), 1e-7);
}

// Random arms between narrow limits are hit again and again.
Release BetweenNarrowLimits(const Figure& arm, Random* random) {
  return {arm, BentArm(), random->Vector(7, 15.0), 1.0 / 3.0};
}

Figure ArmBetweenNarrowLimits(Random* random) {
  VecX lower = BentArm(), upper = BentArm();
  for (int j = 0; j < 7; ++j) {
    lower[j] -= random->LogUniform(0.01, 1.0);
    upper[j] += random->LogUniform(0.01, 1.0);
  }
  return Arm7Within(lower, upper);
}

TEST(Exact, StaysBetweenNarrowLimitsAndGainsNoEnergyThere) {
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const Figure arm = ArmBetweenNarrowLimits(&random);
    const Course course = SwingExactly(BetweenNarrowLimits(arm, &random), 1e-7);
    EXPECT_TRUE(course.finished) << "seed " << seed;
    EXPECT_LE(course.outside, 1e-7) << "seed " << seed;
    EXPECT_LE(course.energy_gain, 1e-6) << "seed " << seed;
    EXPECT_LE(course.evaluations, 50000) << "seed " << seed << ", hits " << course.hits.size();
  }
}

TEST(Paper, StaysBetweenNarrowLimitsButMayGainEnergyThere) {
  double gain = 0.0;
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const Figure arm = ArmBetweenNarrowLimits(&random);
    const Course course = SwingByPaper(BetweenNarrowLimits(arm, &random), 1.0 / 30.0);
    EXPECT_TRUE(course.finished) << "seed " << seed;
    EXPECT_LE(course.outside, 1e-12) << "seed " << seed;
    gain = std::max(gain, course.energy_gain);
  }
  EXPECT_GT(gain, 0.1);
}

// The arm with no room at one joint, and with that joint left out of the region.
void ExpectNoRoomIsAsIfKeyed(int joint, double rate, Method method, double tolerance) {
  VecX lower = VecX::Constant(7, -kInfinity), upper = -lower;
  lower[joint] = upper[joint] = BentArm()[joint];
  VecX qd(7);
  qd << 3.0, -2.0, 1.0, 6.0, 2.0, -3.0, 2.0;
  qd[joint] = 0.0;
  Animation keyed = Released(FreeArm7(), BentArm(), qd, 10, method);
  keyed.regions[0].joints.erase(keyed.regions[0].joints.begin() + joint);
  keyed.regions[0].friction.pop_back();
  qd[joint] = rate;
  Animation stopped = Released(Arm7Within(lower, upper), BentArm(), qd, 10, method);
  for (Animation* animation : {&keyed, &stopped}) SetTolerance(animation, 1e-8);
  const Motion motion = BakeFinite(stopped), expected = BakeFinite(keyed);
  ASSERT_EQ(motion.frames.size(), expected.frames.size());
  const VecX difference = motion.frames.back().q - expected.frames.back().q;
  EXPECT_LE(difference.cwiseAbs().maxCoeff(), tolerance) << NameOf(method) << " joint " << joint;
  EXPECT_LE(motion.regions[0].evaluations, 20 * expected.regions[0].evaluations)
      << NameOf(method) << " joint " << joint;
}

TEST(Exact, TakesAJointWithoutRoomAsAKeyedOne) {
  for (const int joint : {1, 3, 4, 6}) {
    ExpectNoRoomIsAsIfKeyed(joint, 0.0, Method::kExact, 1e-7);
    if (::testing::Test::HasFailure()) return;  // each may take its ten seconds
  }
}

TEST(Paper, TakesAJointWithoutRoomAsAKeyedOne) {
  for (const int joint : {1, 3, 4, 6}) ExpectNoRoomIsAsIfKeyed(joint, 0.0, Method::kPaper, 1e-9);
}

// A level rod pressed on the upper of two limits that are one, and on the lower.
TEST(Exact, HoldsARodWithoutRoomWhicheverWayItIsPressed) {
  for (const double angle : {-1.0, 1.0}) {
    const VecX q = VecX::Constant(1, angle);
    const Figure rod = RodWithin(angle, angle);
    const Course course = SwingExactly({rod, q, VecX::Zero(1), 1.0 / 3.0}, 1e-7, 1000);
    EXPECT_TRUE(course.finished) << angle << ", after 1000 steps at " << course.time << " s";
    EXPECT_LE(std::abs(course.q[0] - angle), 1e-12) << angle;
  }
}

// A rod that swings up to its limit, and hardly gets there, loses what it has left there: it falls
// back as from rest at the limit.
TEST(Exact, FeelsALimitThatASwingBarelyReaches) {
  const double limit = 1.2, start = 0.2;
  // m g c / I of a rod of 1 m and 2 mm radius.
  const double weight = 1.5 * kG / (1.0 + 0.75 * 0.002 * 0.002);
  for (const double beyond : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
    const Figure rod = RodWithin(-10.0, limit);
    const double rate = std::sqrt(2.0 * weight * (std::cos(start) - std::cos(limit + beyond)));
    const VecX q = VecX::Constant(1, start), qd = VecX::Constant(1, rate);
    const Course course = SwingExactly({rod, q, qd, 1.2}, 1e-8);
    ASSERT_TRUE(course.finished);
    EXPECT_EQ(course.hits.size(), 1u) << beyond;
    EXPECT_LE(course.outside, 1e-8) << beyond;
    const double expected = 2.0 * weight * (std::cos(course.q[0]) - std::cos(limit));
    EXPECT_NEAR(course.qd[0] * course.qd[0], expected, 1e-6) << beyond;
  }
}

// A weightless rod that is so slow that it needs 0.1 ms for the distance within which it touches
// its limit: it hits that 5e-11 rad beyond, wherever a step ends.
TEST(Exact, HitsALimitAtOneDistance) {
  constexpr double kLimit = 1e-7, kRate = 1e-6, kHit = 5e-11;  // [rad, rad/s]
  const Figure rod = RodWithin(-10.0, kLimit);
  for (const double beyond : {2e-11, 4e-11, 6e-11, 8e-11, 9.5e-11, 2e-10}) {
    const Course course = SwingExactly({.figure = rod,
                                        .q = VecX::Zero(1),
                                        .qd = VecX::Constant(1, kRate),
                                        .seconds = (kLimit + beyond) / kRate,
                                        .gravity = 0.0},
                                       1e-7);
    ASSERT_TRUE(course.finished);
    ASSERT_EQ(course.hits.size(), beyond > kHit ? 1u : 0u) << beyond;
    if (beyond < kHit) continue;
    EXPECT_NEAR(course.hits[0].time, (kLimit + kHit) / kRate, 1e-8) << beyond;
  }
}

// A rod that starts outside its limits and swings up, but not as far as them: it stays where it
// turns, however long the steps are. On both sides.
TEST(Exact, HoldsARodThatStartsOutsideWhereItTurns) {
  const double start = 0.2;
  const double weight = 1.5 * kG / (1.0 + 0.75 * 0.002 * 0.002);  // as above
  for (const double tolerance : {1e-4, 1e-6, 1e-9}) {
    for (const double rate : {0.5, 2.0, 4.0}) {
      const double turn = std::acos(std::cos(start) - 0.5 * rate * rate / weight);
      for (const int side : {-1, 1}) {
        const Figure rod = side < 0 ? RodWithin(2.5, 10.0) : RodWithin(-10.0, -2.5);
        const VecX q = VecX::Constant(1, -side * start), qd = VecX::Constant(1, -side * rate);
        const Course course = SwingExactly({rod, q, qd, 1.2}, tolerance);
        ASSERT_TRUE(course.finished);
        EXPECT_NEAR(course.q[0], -side * turn, tolerance) << rate << " rad/s";
        EXPECT_EQ(course.qd[0], 0.0) << rate << " rad/s";
      }
    }
  }
}

// A rod that starts outside and swings through its limit, far or so little that it turns in the
// same step, falls back onto that limit.
TEST(Exact, GivesARodThatCameInItsOwnLimit) {
  const double start = 0.2, rate = 3.0;
  const double weight = 1.5 * kG / (1.0 + 0.75 * 0.002 * 0.002);  // as above
  const double turn = std::acos(std::cos(start) - 0.5 * rate * rate / weight);
  for (const double tolerance : {1e-4, 1e-6, 1e-9}) {
    for (const double inside : {0.3, 1e-2, 1e-3, 2e-4}) {
      const VecX q = VecX::Constant(1, start), qd = VecX::Constant(1, rate);
      const Course course = SwingExactly({RodWithin(turn - inside, 10.0), q, qd, 2.0}, tolerance);
      ASSERT_TRUE(course.finished);
      EXPECT_NEAR(course.q[0], turn - inside, 1e-9) << inside << " rad, tolerance " << tolerance;
    }
  }
}

// The second rod whirls and, where it goes up fastest, all but lifts the first off its limit or
// does so for a moment.
Animation WhirlOnALimit(double rate, double tolerance) {
  const Eigen::Vector2d q(-0.5 * std::numbers::pi, 0.0), qd(0.0, rate);
  Animation animation = Released(RodsOnAStop(), q, qd, 18, Method::kExact);
  SetTolerance(&animation, tolerance);
  return animation;
}

TEST(Exact, KeepsItsToleranceWhereALimitLetsGoForAMoment) {
  const double tolerance = SolverSettings().tolerance;
  for (int i = 0; i <= 56; ++i) {
    const double rate = 10.0 + 0.05 * i;
    const Motion motion = BakeFinite(WhirlOnALimit(rate, tolerance));
    const Motion fine = BakeFinite(WhirlOnALimit(rate, 1e-9));
    double worst = 0.0;
    for (size_t f = 0; f < fine.frames.size(); ++f) {
      const VecX difference = motion.frames[f].q - fine.frames[f].q;
      worst = std::max(worst, difference.cwiseAbs().maxCoeff());
    }
    EXPECT_LE(worst, tolerance) << rate << " rad/s; estimate " << motion.regions[0].error_estimate;
  }
}

TEST(BothMethods, HoldAnArmWithoutRoomAnywhere) {
  const Figure arm = Arm7Within(BentArm(), BentArm());
  for (const Method method : {Method::kExact, Method::kPaper}) {
    const VecX qd = VecX::Constant(7, 5.0);
    const Motion motion = BakeFinite(Released(arm, BentArm(), qd, 30, method));
    for (const MotionFrame& frame : motion.frames) {
      EXPECT_LE((frame.q - BentArm()).cwiseAbs().maxCoeff(), 1e-12) << NameOf(method);
    }
  }
}

// Mirror images that swing towards their limits at 6 rad/s without gravity: the bar between them
// feels nothing, and all come to rest at once.
Animation MirrorSwing(double left, double right, Method method) {
  Animation animation =
      Released(MirrorArms(left, right), VecX::Zero(3), Vec3(0, -6, 6), 10, method);
  animation.gravity = 0.0;
  SetTolerance(&animation, 1e-8);
  return animation;
}

TEST(Exact, HitsTwoLimitsAtOnce) {
  const Motion motion = BakeFinite(MirrorSwing(0.5, 0.5, Method::kExact));
  const auto limits = EventsOf(motion, EventKind::kLimit);
  ASSERT_EQ(limits.size(), 2u);
  for (const MotionEvent& limit : limits) EXPECT_NEAR(limit.time, 0.5 / 6.0, 1e-8);
  const MotionFrame& end = motion.frames.back();
  EXPECT_LE((end.q - Vec3(0, -0.5, 0.5)).norm(), 1e-8);
  EXPECT_LE(end.before.qd.norm(), 1e-6);
}

// One limit 1e-6 rad before the other: two hits within a step, in their order. The impulse of the
// first turns the bar, and the bar goes on.
TEST(Exact, HitsTwoLimitsWithinOneStepInTheirOrder) {
  const Animation animation = MirrorSwing(0.5, 0.5 + 1e-6, Method::kExact);
  const Motion motion = BakeFinite(animation);
  const auto limits = EventsOf(motion, EventKind::kLimit);
  ASSERT_GE(limits.size(), 2u);
  EXPECT_EQ(limits[0].joint, "left");
  EXPECT_NEAR(limits[0].time, 0.5 / 6.0, 1e-8);
  EXPECT_EQ(limits[1].joint, "right");
  EXPECT_GT(limits[1].time, limits[0].time);
  EXPECT_LE(limits[1].time, 0.5 / 6.0 + 1e-5);
  EXPECT_LE(EnergyGain(animation, motion), 1e-9);
}

TEST(Paper, HitsTwoLimitsAtOnceButAFrameLate) {
  const Motion motion = BakeFinite(MirrorSwing(0.5, 0.5, Method::kPaper));
  const auto limits = EventsOf(motion, EventKind::kLimit);
  ASSERT_EQ(limits.size(), 2u);
  for (const MotionEvent& limit : limits) EXPECT_NEAR(limit.time, 0.1, 1e-12);
  EXPECT_LE((motion.frames.back().q - Vec3(0, -0.5, 0.5)).norm(), 1e-9);
}

}  // namespace
}  // namespace hazumi::test
