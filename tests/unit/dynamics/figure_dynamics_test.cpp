// Figures and poses that the random trees do not cover, and what holds whatever the figure.

#include "engine/dynamics/figure_dynamics.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "tests/support/compare.h"
#include "tests/support/figures.h"
#include "tests/support/random_tree.h"

namespace hazumi::test {
namespace {

constexpr double kQuarterTurn = 0.5 * std::numbers::pi;

// A figure in a random state on a moving root.
struct Case {
  Case(const Figure& of, uint64_t seed)
      : figure(of), random(seed), moving_root(RandomMovingRoot(&random)), n(of.num_joints()) {
    q = RandomAngles(figure, &random);
    qd = random.Vector(n, 5.0);
    qdd = random.Vector(n, 50.0);
    tau = random.Vector(n, 50.0);
    ends = RandomEndForces(figure, &random);
  }

  VecX Torques(const FigureDynamics& dynamics, FigureScratch* scratch) const {
    VecX result(n);
    dynamics.InverseDynamics(moving_root.X_WR(), moving_root.Motion(), q, qd, qdd, &ends, scratch,
                             &result);
    return result;
  }
  std::optional<SingularInertia> Solve(const FigureDynamics& dynamics, FigureScratch* scratch,
                                       VecX* result) const {
    return dynamics.ForwardDynamics(moving_root.X_WR(), moving_root.Motion(), q, qd, tau, &ends,
                                    scratch, result);
  }
  VecX Accelerations(const FigureDynamics& dynamics, FigureScratch* scratch) const {
    VecX result(n);
    EXPECT_FALSE(Solve(dynamics, scratch, &result).has_value());
    return result;
  }

  // The same by the recursion in world axes and by the dense route.
  DynamicsWorkspace Placed() const {
    DynamicsWorkspace ws(figure);
    ComputePositions(figure, moving_root.X_WR(), q, &ws);
    return ws;
  }
  VecX TorquesInWorldAxes(const VecX& at_qdd) const {
    DynamicsWorkspace ws = Placed();
    hazumi::InverseDynamics(figure, moving_root.Motion(), qd, at_qdd, &ends, &ws);
    return ws.tau;
  }
  VecX DenseAccelerations() const {
    DynamicsWorkspace ws = Placed();
    VecX result(n);
    EXPECT_FALSE(ForwardDynamicsDense(figure, moving_root.Motion(), qd, tau, &ends, &ws, &result));
    return result;
  }

  const Figure figure;
  Random random;
  MovingRoot moving_root;
  int n;
  VecX q, qd, qdd, tau;
  EndForces ends;
};

void ExpectAgreement(const Case& c, const std::string& what) {
  const FigureDynamics dynamics(c.figure);
  FigureScratch scratch = dynamics.MakeScratch();
  EXPECT_LE(RelativeDifference(c.Torques(dynamics, &scratch), c.TorquesInWorldAxes(c.qdd)), 1e-12)
      << what;
  EXPECT_LE(RelativeDifference(c.Accelerations(dynamics, &scratch), c.DenseAccelerations()), 1e-9)
      << what;
}

JointSpec Joint(const std::string& name, const std::string& parent, const std::vector<Vec3>& axes,
                Random* random) {
  JointSpec joint;
  joint.name = name;
  joint.parent = parent;
  joint.offset = random->Vector3(0.3);
  for (size_t h = 0; h < axes.size(); ++h) {
    joint.hinges.push_back({std::string(1, static_cast<char>('a' + h)), axes[h], -3.0, 3.0});
  }
  LinkSpec link;
  link.to = Vec3(0.1, 0.2, -0.3) + random->Vector3(0.1);
  link.radius = 0.05;
  link.mass = 1.0 + random->Uniform(0.0, 1.0);
  joint.links = {link};
  return joint;
}

FigureSpec EmptySpec() {
  FigureSpec spec;
  spec.name = "test";
  spec.root_name = "root";
  return spec;
}

TEST(FigureDynamics, TakesHingesAtAnyAngleToEachOther) {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    FigureSpec spec = EmptySpec();
    spec.joints = {Joint("skew", "root", {x, (y + 0.3 * x), (z + 0.5 * y)}, &random),
                   Joint("euler", "skew", {z, x, z}, &random),
                   Joint("two", "euler", {random.Vector3(1.0), random.Vector3(1.0)}, &random),
                   Joint("left_handed", "euler", {y, x, z}, &random),
                   Joint("backwards", "left_handed", {-z, -x}, &random)};
    ExpectAgreement(Case(Build(spec), seed), "seed " + std::to_string(seed));
  }
}

TEST(FigureDynamics, TakesFiguresOfEveryShape) {
  for (const int arms : {1, 2, 3, 4, 5, 9}) {
    for (const int joints : {1, 2, 5}) {
      Random random(arms * 10 + joints);
      FigureSpec spec = EmptySpec();
      for (int a = 0; a < arms; ++a) {
        std::string parent = "root";
        for (int j = 0; j < joints; ++j) {
          const Mat3 axes = random.Rotation();
          std::vector<Vec3> hinges = {axes.col(0), axes.col(1), axes.col(2)};
          hinges.resize(1 + (a + j) % 3);
          const std::string name = std::to_string(a) + "-" + std::to_string(j);
          spec.joints.push_back(Joint(name, parent, hinges, &random));
          // Every second arm branches off the one before.
          parent = a % 2 == 1 && j == 0 ? std::to_string(a - 1) + "-0" : name;
        }
      }
      ExpectAgreement(Case(Build(spec), arms),
                      std::to_string(arms) + " x " + std::to_string(joints));
    }
  }
}

TEST(FigureDynamics, TakesALoadBetweenTheHingesOfAJoint) {
  const RigidInertia load{2.0, Vec3(0.1, 0.2, 0.3), 0.1 * Mat3::Identity()};
  for (const int joint : {0, 1, 2, 9, 10, 30, 36}) {
    ExpectAgreement(Case(Human37().WithLoad(JointIndex(joint), load), 5), std::to_string(joint));
  }
}

TEST(FigureDynamics, TakesLargeAngles) {
  Case c(Human37(), 8);
  c.q[3] += 2e5;
  c.q[20] -= 1e9;
  c.q[36] += 1e4;
  ExpectAgreement(c, "large angles");
}

TEST(FigureDynamics, TakesAFigureWithoutJoints) {
  FigureSpec spec = EmptySpec();
  spec.root_links = Joint("", "", {}, std::make_unique<Random>(1).get()).links;
  ExpectAgreement(Case(Build(spec), 1), "no joints");
}

TEST(FigureDynamics, GivesTheSameBitsWithEveryInstructionSet) {
  if (BestInstructions() == Instructions::kBaseline) GTEST_SKIP() << "only one here";
  for (uint64_t seed = 0; seed <= 50; ++seed) {
    Random random(seed);
    const Case c(seed == 0 ? Human37() : Build(RandomTreeSpec(&random)), seed);
    const FigureDynamics plain(c.figure, Instructions::kBaseline), best(c.figure);
    FigureScratch of_plain = plain.MakeScratch(), of_best = best.MakeScratch();
    EXPECT_EQ(c.Torques(plain, &of_plain), c.Torques(best, &of_best)) << "seed " << seed;
    EXPECT_EQ(c.Accelerations(plain, &of_plain), c.Accelerations(best, &of_best))
        << "seed " << seed;
  }
}

TEST(FigureDynamics, KeepsNothingFromOneUseToTheNext) {
  const Case first(Human37(), 1), second(Human37(), 2);
  const FigureDynamics dynamics(first.figure);
  FigureScratch used = dynamics.MakeScratch(), fresh = dynamics.MakeScratch();
  (void)first.Torques(dynamics, &used);
  (void)first.Accelerations(dynamics, &used);
  EXPECT_EQ(second.Torques(dynamics, &used), second.Torques(dynamics, &fresh));
  EXPECT_EQ(second.Accelerations(dynamics, &used), second.Accelerations(dynamics, &fresh));
}

// Hinges about y and z in turn, 0.1 m apart.
FigureSpec Chain(int joints) {
  FigureSpec spec = EmptySpec();
  Random random(1);
  for (int i = 0; i < joints; ++i) {
    JointSpec joint = Joint("j" + std::to_string(i), i == 0 ? "root" : "j" + std::to_string(i - 1),
                            {i % 2 == 0 ? Vec3::UnitY() : Vec3::UnitZ()}, &random);
    joint.offset = Vec3(0.1, 0.0, 0.0);
    spec.joints.push_back(joint);
  }
  return spec;
}

TEST(FigureDynamics, OfChainsIsUndoneByTheInverse) {
  for (const int joints : {1, 10, 100, 1000}) {
    Case c(Build(Chain(joints)), joints);
    c.q *= 0.1;
    c.qd *= 0.1;
    const FigureDynamics dynamics(c.figure);
    FigureScratch scratch = dynamics.MakeScratch();
    const VecX qdd = c.Accelerations(dynamics, &scratch);
    // The torques are a small difference of what the rates and the accelerations ask for.
    const double size = c.TorquesInWorldAxes(VecX::Zero(joints)).cwiseAbs().maxCoeff() + 50.0;
    const VecX difference = c.TorquesInWorldAxes(qdd) - c.tau;
    EXPECT_LE(difference.cwiseAbs().maxCoeff(), 1e-12 * size) << joints;
  }
}

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
