// Numbers far from those of an arm.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/animations.h"
#include "tests/support/arm7_cases.h"
#include "tests/support/odd_figures.h"
#include "tests/support/passive_swing.h"
#include "tests/support/random.h"
#include "tests/support/released.h"

namespace hazumi::test {
namespace {

constexpr double kTolerance = 1e-8;   // of a step [rad]
constexpr double kSwing = 1.0 / 3.0;  // [s]

VecX Rates(double shoulder, double elbow, double wrist) {
  VecX qd(7);
  qd << shoulder, -shoulder, shoulder, elbow, -elbow, wrist, -wrist;
  return qd;
}

// Where the hand is a thousandth of what it was and spins.
Release LightHand(const Figure& arm) { return {arm, BentArm(), Rates(1.0, 1.0, 100.0), kSwing}; }

TEST(Exact, KeepsTheEnergyOfALightHandThatSpins) {
  const Figure arm = FreeArm7(1e-3);
  const Course course = SwingExactly(LightHand(arm), kTolerance);
  EXPECT_TRUE(course.finished);
  EXPECT_LE(course.energy_drift, 1e-6);
  EXPECT_LE(course.evaluations, 20000);
}

TEST(Paper, ExplodesWithALightHandThatSpins) {
  const Figure arm = FreeArm7(1e-3);
  const Course course = SwingByPaper(LightHand(arm), 1.0 / 30.0);
  EXPECT_TRUE(!course.finished || course.energy_drift > 10.0) << course.energy_drift;
}

// What the hand has to do with the rest is lost in the sixth digit of the arm's inertia.
TEST(Exact, KeepsTheEnergyAtAMassRatioOfAMillion) {
  const Figure arm = FreeArm7(1e-6);
  const Course course = SwingExactly({arm, BentArm(), Rates(3.0, 8.0, 5.0), kSwing}, kTolerance);
  EXPECT_TRUE(course.finished);
  EXPECT_LE(course.energy_drift, 1e-6);
}

// An independent formulation: as the hand's mass goes to 0, the arm moves as it does without one.
TEST(Exact, MovesAnArmWithAHandOfNearlyNoMassAsWithOneOfATenthOfThat) {
  const Figure light = FreeArm7(1e-6), lighter = FreeArm7(1e-7);
  const Release a{light, BentArm(), Rates(3.0, 8.0, 5.0), kSwing};
  const Release b{lighter, BentArm(), Rates(3.0, 8.0, 5.0), kSwing};
  const VecX difference = SwingExactly(a, kTolerance).q - SwingExactly(b, kTolerance).q;
  EXPECT_LE(difference.head<5>().cwiseAbs().maxCoeff(), 1e-5);
}

TEST(Paper, MultipliesTheEnergyAtAMassRatioOfAMillion) {
  const Figure arm = FreeArm7(1e-6);
  const Course course = SwingByPaper({arm, BentArm(), Rates(3.0, 8.0, 5.0), kSwing}, 1.0 / 30.0);
  EXPECT_TRUE(!course.finished || course.energy_drift > 1.0) << course.energy_drift;
}

// A thousand radians a second are 53 turns in a swing.
TEST(Exact, KeepsTheEnergyOfAnArmThatStartsWithAThousandRadiansASecond) {
  const Figure arm = FreeArm7();
  const Course course =
      SwingExactly({arm, BentArm(), Rates(1000.0, 1000.0, 1000.0), kSwing}, kTolerance);
  EXPECT_TRUE(course.finished);
  EXPECT_LE(course.energy_drift, 1e-5);
  EXPECT_LE(course.evaluations, 500000);
}

// Nobody can tell where such an arm ends; the bake must end all the same.
TEST(Exact, BakesAnArmThatStartsWithAThousandRadiansASecond) {
  const Animation animation =
      Released(FreeArm7(), BentArm(), Rates(1000.0, 1000.0, 1000.0), 10, Method::kExact);
  const Motion motion = BakeFinite(animation);
  ASSERT_FALSE(motion.frames.empty());
  EXPECT_LE(std::abs(EnergyGain(animation, motion)), 0.01);
}

TEST(Paper, SaysThatAnArmOfAThousandRadiansASecondExplodes) {
  const Animation animation =
      Released(FreeArm7(), BentArm(), Rates(1000.0, 1000.0, 1000.0), 10, Method::kPaper);
  EXPECT_FALSE(BakeSoundly(animation).ok());
}

TEST(Exact, SaysWhichJointMovesTooFastToFollow) {
  Animation animation = Released(FreeArm7(), BentArm(), Rates(0.0, 0.0, 0.0), 10, Method::kExact);
  KeysOf(&animation, "r_wrist_y")[0].rate = 1e14;
  const Result<Motion> motion = BakeSoundly(animation);
  ASSERT_FALSE(motion.ok());
  EXPECT_NE(motion.error().message.find("\"r_wrist_"), std::string::npos)
      << motion.error().ToString();
}

TEST(Paper, SaysWhichJointMovesTooFastToFollow) {
  Animation animation = Released(FreeArm7(), BentArm(), Rates(0.0, 0.0, 0.0), 10, Method::kPaper);
  KeysOf(&animation, "r_wrist_y")[0].rate = 1e14;
  EXPECT_FALSE(BakeSoundly(animation).ok());
}

TEST(BothMethods, LeaveAFigureAtRestWithoutGravityAsItIs) {
  for (const Method method : {Method::kExact, Method::kPaper}) {
    Animation animation = Released(FreeArm7(), BentArm(), Rates(0.0, 0.0, 0.0), 30, method);
    animation.gravity = 0.0;
    const Motion motion = BakeFinite(animation);
    for (const MotionFrame& frame : motion.frames) {
      EXPECT_LE((frame.q - BentArm()).cwiseAbs().maxCoeff(), 1e-15) << NameOf(method);
    }
  }
}

TEST(BothMethods, TurnASinglePendulumUniformlyWithoutGravity) {
  for (const Method method : {Method::kExact, Method::kPaper}) {
    Animation animation = Released(Chain(1), VecX::Zero(1), VecX::Constant(1, 3.0), 30, method);
    animation.gravity = 0.0;
    EXPECT_NEAR(BakeFinite(animation).frames.back().q[0], 3.0, 1e-10) << NameOf(method);
  }
}

TEST(Exact, KeepsTheEnergyOfAnArmWithoutGravity) {
  const Figure arm = FreeArm7();
  const Release release{arm, BentArm(), Rates(3.0, 8.0, 5.0), kSwing, 0.0};
  EXPECT_LE(SwingExactly(release, kTolerance).energy_drift, 1e-7);
}

TEST(Paper, ChangesTheEnergyOfAnArmWithoutGravity) {
  const Figure arm = FreeArm7();
  const Release release{arm, BentArm(), Rates(3.0, 8.0, 5.0), kSwing, 0.0};
  EXPECT_GT(SwingByPaper(release, 1.0 / 30.0).energy_drift, 0.3);
}

}  // namespace
}  // namespace hazumi::test
