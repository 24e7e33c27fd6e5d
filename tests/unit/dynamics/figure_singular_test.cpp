// The dynamics of whole figures at, next to and after poses in which a joint moves no mass.

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "tests/unit/dynamics/figure_case.h"

namespace hazumi::test {
namespace {

constexpr double kQuarterTurn = 0.5 * std::numbers::pi;

// An arm whose shoulder has hinges about these axes.
Figure ArmWithShoulder(const std::vector<Vec3>& axes) {
  Random random(4);
  FigureSpec spec = EmptySpec();
  spec.joints = {Joint("shoulder", "root", axes, &random),
                 Joint("elbow", "shoulder", {Vec3::UnitY(), Vec3::UnitZ()}, &random),
                 Joint("wrist", "elbow", {Vec3::UnitX(), Vec3::UnitY()}, &random)};
  return Build(spec);
}

// Angles about x, y, z, in this order, of the turn y x z by `yxz`.
Vec3 AnglesXyz(const Vec3& yxz) {
  const Mat3 R =
      (Eigen::AngleAxisd(yxz[0], Vec3::UnitY()) * Eigen::AngleAxisd(yxz[1], Vec3::UnitX()) *
       Eigen::AngleAxisd(yxz[2], Vec3::UnitZ()))
          .toRotationMatrix();
  return {std::atan2(-R(1, 2), R(2, 2)), std::asin(R(0, 2)), std::atan2(-R(0, 1), R(0, 0))};
}

VecX PassiveAccelerations(const Figure& figure, const Vec3& shoulder) {
  const FigureDynamics dynamics(figure);
  FigureScratch scratch = dynamics.MakeScratch();
  VecX q(7), qd(7), qdd(7);
  q << shoulder, -1.1, 0.7, 0.4, -0.3;
  qd << Vec3::Zero(), 3.0, -2.0, 5.0, 1.0;
  RootMotion root;
  root.a = Vec3(0.0, 0.0, 9.81);
  EXPECT_FALSE(dynamics.ForwardDynamics(Pose(), root, q, qd, VecX::Zero(7), nullptr, &scratch, &qdd)
                   .has_value());
  return qdd;
}

// Without torques three hinges are a ball joint: the rest of the arm cannot tell which hinges make
// it, not even where they all but line up.
TEST(FigureDynamics, NextToTheSingularPoseTheRestOfTheArmMovesAsOnABallJoint) {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  const Figure singular = ArmWithShoulder({y, x, z}), regular = ArmWithShoulder({x, y, z});
  for (const double apart : {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const Vec3 angles(0.3, kQuarterTurn - apart, -0.4);
    const VecX near = PassiveAccelerations(singular, angles);
    const VecX safe = PassiveAccelerations(regular, AnglesXyz(angles));
    EXPECT_LE(RelativeDifference(near.tail(4), safe.tail(4)), 1e-12) << apart;
  }
}

// A random tree with one more hinge, which carries nothing.
Figure WithEmptyHinge(uint64_t seed) {
  Random random(seed);
  FigureSpec spec = RandomTreeSpec(&random);
  const int parent = random.Integer(0, static_cast<int>(spec.joints.size()) - 1);
  JointSpec empty = Joint("empty", spec.joints[parent].name, {Vec3::UnitX()}, &random);
  empty.hinges[0].name = "";
  empty.links.clear();
  spec.joints.push_back(empty);
  return Build(spec);
}

TEST(FigureDynamics, ReportsAMasslessLeafByItsJoint) {
  for (uint64_t seed = 1; seed <= 50; ++seed) {
    const Case c(WithEmptyHinge(seed), seed);
    const FigureDynamics dynamics(c.figure);
    FigureScratch scratch = dynamics.MakeScratch();
    VecX qdd(c.n);
    const auto singular = c.Solve(dynamics, &scratch, &qdd);
    ASSERT_TRUE(singular.has_value()) << "seed " << seed;
    EXPECT_EQ(c.figure.joint(singular->joint).name, "empty") << "seed " << seed;
  }
}

TEST(FigureDynamics, ReportsHingesThatLineUpHoweverTheFigureIsTurned) {
  for (uint64_t seed = 1; seed <= 100; ++seed) {
    Case c(Human37(), seed);
    c.q[10] = kQuarterTurn;  // the left shoulder's y and z hinges in one line
    const FigureDynamics dynamics(c.figure);
    FigureScratch scratch = dynamics.MakeScratch();
    VecX qdd(c.n);
    const auto singular = c.Solve(dynamics, &scratch, &qdd);
    ASSERT_TRUE(singular.has_value()) << "seed " << seed;
    EXPECT_EQ(c.figure.group(c.figure.joint(singular->joint).group).name, "l_shoulder");
  }
}

TEST(FigureDynamics, AfterASingularPoseWorksAsBefore) {
  Case c(Human37(), 3);
  const FigureDynamics dynamics(c.figure);
  FigureScratch scratch = dynamics.MakeScratch();
  const VecX before = c.Accelerations(dynamics, &scratch);
  VecX qdd(c.n);
  const double angle = c.q[10];
  c.q[10] = kQuarterTurn;
  EXPECT_TRUE(c.Solve(dynamics, &scratch, &qdd).has_value());
  c.q[10] = angle;
  EXPECT_EQ(c.Accelerations(dynamics, &scratch), before);
}

}  // namespace
}  // namespace hazumi::test
