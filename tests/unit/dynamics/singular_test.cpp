#include "tests/support/compare.h"
#include "tests/support/dense_dynamics.h"
#include "tests/support/figures.h"
#include "tests/support/random_tree.h"

namespace hazumi::test {
namespace {

std::optional<JointIndex> Solve(const Figure& figure, const VecX& q, const Pose& X_WR = Pose()) {
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, X_WR, q, &ws);
  const VecX zero = VecX::Zero(figure.num_joints());
  VecX qdd(figure.num_joints());
  return ForwardDynamics(figure, RootMotion(), zero, zero, nullptr, &ws, &qdd);
}

// A random tree with one more hinge, which carries nothing.
Figure WithEmptyLeaf(uint64_t seed) {
  Random random(seed);
  FigureSpec spec = RandomTreeSpec(&random);
  const int parent = random.Integer(0, static_cast<int>(spec.joints.size()) - 1);
  JointSpec empty;
  empty.name = "empty";
  empty.parent = spec.joints[parent].name;
  empty.offset = random.Vector3(0.3);
  empty.hinges = {{"", Vec3::UnitX(), -1.0, 1.0}};
  spec.joints.push_back(empty);
  return Build(spec);
}

TEST(ForwardDynamics, ReportsAMasslessLeafByItsJoint) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    const Figure figure = WithEmptyLeaf(seed);
    Random random(~seed);
    const VecX q = RandomAngles(figure, &random);
    const auto singular = Solve(figure, q);
    ASSERT_TRUE(singular.has_value()) << "seed " << seed;
    EXPECT_EQ(figure.joint(*singular).name, "empty") << "seed " << seed;
  }
}

TEST(ForwardDynamics, ReportsHingesThatLineUpHoweverTheFigureIsTurned) {
  const Figure human = Human37();
  for (uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    VecX q = RandomAngles(human, &random);
    q[10] = 1.57079632679489661923;  // the left shoulder's y and z hinges in one line
    const Pose X_WR{random.Rotation(), random.Vector3(1.0)};
    const auto singular = Solve(human, q, X_WR);
    ASSERT_TRUE(singular.has_value()) << "seed " << seed;
    EXPECT_EQ(human.group(human.joint(*singular).group).name, "l_shoulder");
  }
}

TEST(ForwardDynamics, ReportsNothingForAHealthyFigure) {
  const Figure human = Human37();
  Random random(1);
  const VecX q = RandomAngles(human, &random);
  EXPECT_FALSE(Solve(human, q).has_value());
}

TEST(DynamicsWorkspace, HoldsNothingFromOneUseToTheNext) {
  const Figure human = Human37();
  Random random(2);
  const VecX q = RandomAngles(human, &random), qd = random.Vector(37, 3.0);
  const auto torques = [&](DynamicsWorkspace* ws) {
    ComputePositions(human, Pose(), q, ws);
    InverseDynamics(human, RootMotion(), qd, qd, nullptr, ws);
    return VecX(ws->tau);
  };
  DynamicsWorkspace fresh(human), used(human);
  ComputePositions(human, Pose(), qd, &used);
  InverseDynamics(human, RootMotion(), q, q, nullptr, &used);
  EXPECT_EQ(torques(&used), torques(&fresh));
}

}  // namespace
}  // namespace hazumi::test
