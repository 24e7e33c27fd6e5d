// Friction at and next to the ends of its range. A factor of 1e-12 is a rate of 829 1/s; it is not
// a factor of 0. [METHOD 2.3, 2.4]

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/animations.h"
#include "tests/support/odd_figures.h"
#include "tests/support/released.h"

namespace hazumi::test {
namespace {

const double kNearlyAll = 1e-12;
const double kRate = -30.0 * std::log(kNearlyAll);  // [1/s]

// One rod turning without gravity, or falling from the horizontal.
Animation Rod(double factor, double rate, double gravity, Method method) {
  Animation animation =
      Released(Chain(1), VecX::Constant(1, -std::acos(0.0)), VecX::Constant(1, rate), 10, method);
  animation.gravity = gravity;
  animation.regions[0].friction[0] = factor;
  SetTolerance(&animation, 1e-8);
  return animation;
}

double Turned(const Animation& animation) {
  const Motion motion = BakeFinite(animation);
  return motion.frames.back().q[0] - motion.frames.front().q[0];
}

TEST(BothMethods, FreezeASingleJointWithFrictionZero) {
  for (const Method method : {Method::kExact, Method::kPaper}) {
    EXPECT_EQ(Turned(Rod(0.0, 5.0, 9.81, method)), 0.0) << NameOf(method);
  }
}

TEST(Exact, LosesNothingWithFrictionOne) {
  const Animation animation = Rod(1.0, 5.0, 9.81, Method::kExact);
  EXPECT_LE(std::abs(EnergyGain(animation, BakeFinite(animation))), 1e-8);
}

// q = q0 + r / c (1 - exp(-c t))
TEST(Exact, LetsAJointWithNearlyAllFrictionRunOut) {
  EXPECT_NEAR(Turned(Rod(kNearlyAll, 5.0, 0.0, Method::kExact)), 5.0 / kRate, 1e-8);
}

// It creeps at x / c, x = 3 g / 2 being the acceleration of a rod of 1 m let go level; the change
// of x on the way is worth 1e-4 of it.
TEST(Exact, LetsAJointWithNearlyAllFrictionCreep) {
  const double creep = 1.5 * 9.81 / kRate * (1.0 / 3.0 - 1.0 / kRate);
  EXPECT_NEAR(Turned(Rod(kNearlyAll, 0.0, 9.81, Method::kExact)) / creep, 1.0, 1e-3);
}

// The step multiplies what gravity adds in it by 1e-12 too.
TEST(Paper, HardlyMovesAJointWithNearlyAllFriction) {
  EXPECT_LE(Turned(Rod(kNearlyAll, 0.0, 9.81, Method::kPaper)), 1e-10);
}

TEST(Exact, DoesNotCareHowNearToZeroFrictionIs) {
  for (const double factor : {1e-30, 1e-100, 1e-300}) {
    const Animation animation = Rod(factor, 5.0, 0.0, Method::kExact);
    EXPECT_NEAR(Turned(animation), 5.0 / (-30.0 * std::log(factor)), 1e-8) << factor;
  }
}

// An arm of two rods of which the second is frozen, and one whose second is not in the region.
Animation TwoRods(double factor, bool second_in_region, Method method) {
  VecX q(2), qd(2);
  q << -1.0, -1.0;
  qd << 2.0, 6.0;
  Animation animation = Released(Chain(2), q, qd, 10, method);
  animation.regions[0].friction[1] = factor;
  SetTolerance(&animation, 1e-8);
  if (second_in_region) return animation;
  animation.joint_keys[1] = {{0.0, q[1], 0.0, Interpolation::kHold}};
  animation.regions[0].joints.pop_back();
  animation.regions[0].friction.pop_back();
  return animation;
}

double FirstAngle(const Animation& animation) { return BakeFinite(animation).frames.back().q[0]; }

TEST(Exact, LetsTheOthersFeelAFrozenJointRigid) {
  const double frozen = FirstAngle(TwoRods(0.0, true, Method::kExact));
  EXPECT_NEAR(frozen, FirstAngle(TwoRods(1.0, false, Method::kExact)), 1e-8);
}

// Friction is a rule for accelerations: with 1e-12 the first rod moves as if the second were free,
// and lost its rate without an impulse.
TEST(Exact, TellsNearlyAllFrictionFromAFrozenJoint) {
  const double frozen = FirstAngle(TwoRods(0.0, true, Method::kExact));
  const double damped = FirstAngle(TwoRods(kNearlyAll, true, Method::kExact));
  EXPECT_GT(std::abs(frozen - damped), 1e-3);
}

// The paper's step solves as if the frozen joint were free.
TEST(Paper, LetsTheOthersFeelAFrozenJointAsIfItGaveWay) {
  const double frozen = FirstAngle(TwoRods(0.0, true, Method::kPaper));
  EXPECT_GT(std::abs(frozen - FirstAngle(TwoRods(1.0, false, Method::kPaper))), 0.01);
}

}  // namespace
}  // namespace hazumi::test
