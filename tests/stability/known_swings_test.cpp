// The swings with known results. [METHOD 8.4]

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/region/hinge_triple.h"
#include "engine/spatial/degrees.h"
#include "tests/support/animations.h"
#include "tests/support/arm7_cases.h"
#include "tests/support/odd_figures.h"
#include "tests/support/released.h"

namespace hazumi::test {
namespace {

Animation AnimationOf(const ArmCase& c, Method method, double tolerance = 1e-8) {
  Animation animation = Released(Arm7Within(c.lower_deg * kDegree, c.upper_deg * kDegree),
                                 c.start_deg * kDegree, c.start_rate, kArmCaseFrames, method);
  for (int j = 0; j < 7; ++j) animation.regions[0].friction[j] = c.friction[j];
  SetTolerance(&animation, tolerance);
  return animation;
}

Motion BakeCase(const ArmCase& c, Method method, double tolerance = 1e-8) {
  return BakeFinite(AnimationOf(c, method, tolerance));
}

double WorstErrorDeg(const Motion& motion, const Vec7& expected_deg) {
  return (motion.frames.back().q / kDegree - expected_deg).cwiseAbs().maxCoeff();
}

// Of the shoulder's orientation and the other angles at the end of NearGimbal, in degrees.
double NearGimbalErrorDeg(const Motion& motion) {
  const HingeTriple shoulder(Vec3::UnitY(), Vec3::UnitX(), Vec3::UnitZ());
  const Eigen::Quaterniond end(0.711424127, 0.614374034, 0.071752579, -0.333574317);
  const VecX q = motion.frames.back().q;
  const Eigen::Quaterniond turn(shoulder.Rotation(q.head<3>()));
  const VecX beyond = q.tail<4>() / kDegree - NearGimbal().converged_deg.tail<4>();
  return std::max(turn.angularDistance(end.normalized()) / kDegree, beyond.cwiseAbs().maxCoeff());
}

TEST(Exact, SwingsOntoItsLimitsAsTheReference) {
  const Motion motion = BakeCase(SwingWithLimits(), Method::kExact);
  EXPECT_LE(WorstErrorDeg(motion, SwingWithLimits().converged_deg) * kDegree, 1e-6);
  const auto limits = EventsOf(motion, EventKind::kLimit);
  ASSERT_EQ(limits.size(), 2u);
  EXPECT_EQ(limits[0].joint, "r_elbow_y");
  EXPECT_NEAR(limits[0].time, 0.151513471, 1e-7);
  EXPECT_EQ(limits[1].joint, "r_elbow_z");
  EXPECT_NEAR(limits[1].time, 0.234207281, 1e-7);
}

TEST(Paper, IsTensOfDegreesOffWhereAnArmSwingsOntoItsLimits) {
  const Motion motion = BakeCase(SwingWithLimits(), Method::kPaper);
  EXPECT_NEAR(WorstErrorDeg(motion, SwingWithLimits().converged_deg), 27.0, 0.1);
}

TEST(Exact, SwingsFreelyAsTheReference) {
  const Animation animation = AnimationOf(FreeSwing(), Method::kExact);
  const Motion motion = BakeFinite(animation);
  EXPECT_LE(WorstErrorDeg(motion, FreeSwing().converged_deg) * kDegree, 1e-6);
  EXPECT_LE(std::abs(EnergyGain(animation, motion)), 1e-8);
}

TEST(Paper, EndsAFreeSwingWithManyTimesItsEnergy) {
  const Animation animation = AnimationOf(FreeSwing(), Method::kPaper);
  const Motion motion = BakeFinite(animation);
  EXPECT_GT(EnergyGain(animation, motion), 10.0);
  EXPECT_GT(WorstErrorDeg(motion, FreeSwing().converged_deg), 180.0);
}

TEST(Exact, PassesTheGimbalLockForAtMostTwiceTheWorkOfAFreeSwing) {
  const Motion near = BakeCase(NearGimbal(), Method::kExact);
  const Motion free = BakeCase(FreeSwing(), Method::kExact);
  EXPECT_LE(NearGimbalErrorDeg(near), 0.001);
  EXPECT_LE(near.regions[0].evaluations, 2 * free.regions[0].evaluations);
}

// And at the tolerance that a new file has.
TEST(Exact, KeepsItsToleranceInTheKnownSwings) {
  const double tolerance = SolverSettings().tolerance;
  const Motion free = BakeCase(FreeSwing(), Method::kExact, tolerance);
  EXPECT_LE(WorstErrorDeg(free, FreeSwing().converged_deg) * kDegree, tolerance);
  const Motion limits = BakeCase(SwingWithLimits(), Method::kExact, tolerance);
  EXPECT_LE(WorstErrorDeg(limits, SwingWithLimits().converged_deg) * kDegree, tolerance);
  const Motion near = BakeCase(NearGimbal(), Method::kExact, tolerance);
  EXPECT_LE(NearGimbalErrorDeg(near) * kDegree, tolerance);
  EXPECT_LE(near.regions[0].evaluations, 2 * free.regions[0].evaluations);
}

TEST(Paper, StopsWithAReportNearTheGimbalLock) {
  Animation animation = AnimationOf(NearGimbal(), Method::kPaper);
  SetStep(&animation, 1.0 / 3000.0);
  const Result<Motion> motion = BakeSoundly(animation);
  ASSERT_FALSE(motion.ok());
  EXPECT_NE(motion.error().message.find("its rate grows without bound"), std::string::npos)
      << motion.error().ToString();
}

}  // namespace
}  // namespace hazumi::test
