// Many joints, and much time. The longest are in slow_test.cpp.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/arm7_cases.h"
#include "tests/support/odd_figures.h"
#include "tests/support/passive_swing.h"
#include "tests/support/released.h"

namespace hazumi::test {
namespace {

constexpr double kRadian = 57.295779513082320877;  // in degrees

Release FreeSwingFor(double seconds, const Figure& arm) {
  return {arm, FreeSwing().start_deg / kRadian, FreeSwing().start_rate, seconds};
}

// A tenth of the tolerance for each step, as the bake gives it.
TEST(Exact, KeepsTheEnergyOfAFreeSwingForAMinute) {
  const Figure arm = FreeArm7();
  const Course course = SwingExactly(FreeSwingFor(60.0, arm), 1e-9);
  EXPECT_TRUE(course.finished);
  EXPECT_LE(course.energy_drift, 1e-6);
}

TEST(Paper, ExplodesInASecondOfFreeSwing) {
  const Figure arm = FreeArm7();
  const Course course = SwingByPaper(FreeSwingFor(1.0, arm), 1.0 / 30.0);
  EXPECT_TRUE(!course.finished || course.energy_drift > 100.0) << course.energy_drift;
}

// Where an arm without friction is after three seconds no tolerance can tell. A bake that cannot
// keep its tolerance must end with a motion all the same, and say so in its report.
TEST(Exact, BakesASwingWhoseEndNoToleranceCanTell) {
  const Animation animation = Released(FreeArm7(), FreeSwing().start_deg / kRadian,
                                       FreeSwing().start_rate, 90, Method::kExact);
  const Motion motion = BakeFinite(animation);
  ASSERT_FALSE(motion.frames.empty());
  EXPECT_LE(std::abs(EnergyGain(animation, motion)), 1e-3);
  EXPECT_GT(motion.regions[0].error_estimate, motion.regions[0].tolerance);
}

// A rope let go level; a thousand links are in slow_test.cpp.
Release Rope(const Figure& chain, double seconds) {
  VecX q = VecX::Zero(chain.num_joints());
  q[0] = -std::acos(0.0);
  return {chain, q, VecX::Zero(chain.num_joints()), seconds};
}

TEST(Exact, KeepsTheEnergyOfTwoHundredFallingLinks) {
  const Figure chain = Chain(200);
  const Course course = SwingExactly(Rope(chain, 1.0 / 30.0), 1e-6);
  EXPECT_TRUE(course.finished);
  EXPECT_LE(course.energy_drift, 1e-6);
  EXPECT_LE(course.evaluations, 500);
}

// The first frame's velocity is its acceleration times 1/30 s: the falling end loses its way at
// the second.
TEST(Paper, GivesFallingLinksEnergyFromNowhere) {
  const Figure chain = Chain(200);
  const Course course = SwingByPaper(Rope(chain, 1.0 / 3.0), 1.0 / 30.0);
  EXPECT_TRUE(!course.finished || course.energy_drift > 1.0) << course.energy_drift;
}

}  // namespace
}  // namespace hazumi::test
