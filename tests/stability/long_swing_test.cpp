// Many joints, and much time.

#include <gtest/gtest.h>

#include <cmath>
#include <ctime>

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

TEST(Exact, KeepsTheEnergyOfAFreeSwingForTenMinutes) {
  const Figure arm = FreeArm7();
  const Course course = SwingExactly(FreeSwingFor(600.0, arm), 1e-9);
  EXPECT_TRUE(course.finished);
  EXPECT_LE(course.energy_drift, 1e-6);
}

TEST(Paper, ExplodesInASecondOfFreeSwing) {
  const Figure arm = FreeArm7();
  const Course course = SwingByPaper(FreeSwingFor(1.0, arm), 1.0 / 30.0);
  EXPECT_TRUE(!course.finished || course.energy_drift > 100.0) << course.energy_drift;
}

// Where an arm without friction is after ten seconds no tolerance can tell. A bake that cannot keep
// its tolerance must end with a motion, and say so in its report.
TEST(Exact, BakesASwingWhoseEndNoToleranceCanTell) {
  const Animation animation = Released(FreeArm7(), FreeSwing().start_deg / kRadian,
                                       FreeSwing().start_rate, 300, Method::kExact);
  const std::clock_t start = std::clock();
  const Motion motion = BakeFinite(animation);
  EXPECT_LE(double(std::clock() - start) / CLOCKS_PER_SEC, 20.0);
  ASSERT_FALSE(motion.regions.empty());
  EXPECT_LE(std::abs(EnergyGain(animation, motion)), 1e-3);
}

// A rope of a thousand links let go level.
Release Rope(const Figure& chain, double seconds) {
  VecX q = VecX::Zero(chain.num_joints());
  q[0] = -std::acos(0.0);
  return {chain, q, VecX::Zero(chain.num_joints()), seconds};
}

TEST(Exact, LetsAThousandLinksFall) {
  const Figure chain = Chain(1000);
  const std::clock_t start = std::clock();
  const Course course = SwingExactly(Rope(chain, 1.0 / 30.0), 1e-4);
  EXPECT_TRUE(course.finished);
  EXPECT_LE(course.energy_drift, 1e-4);
  RecordProperty("seconds", std::to_string(double(std::clock() - start) / CLOCKS_PER_SEC));
  RecordProperty("steps", static_cast<int>(course.steps));
}

TEST(Paper, LetsAThousandLinksFallForAFrame) {
  const Figure chain = Chain(1000);
  const Course course = SwingByPaper(Rope(chain, 1.0 / 30.0), 1.0 / 30.0);
  EXPECT_TRUE(course.finished);
  RecordProperty("drift", std::to_string(course.energy_drift));
}

}  // namespace
}  // namespace hazumi::test
