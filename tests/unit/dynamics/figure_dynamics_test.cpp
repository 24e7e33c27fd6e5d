// Figures and poses that the random trees do not cover, and what holds whatever the figure.

#include <memory>
#include <string>

#include "tests/unit/dynamics/figure_case.h"

namespace hazumi::test {
namespace {

void ExpectLanesAgree(const Case& c, const std::string& what) {
  const FigureDynamics dynamics(c.figure);
  FigureScratch scratch = dynamics.MakeScratch();
  EXPECT_LE(RelativeDifference(c.Torques(dynamics, &scratch), c.TorquesInWorldAxes(c.qdd)), 1e-12)
      << what;
}

TEST(FigureDynamics, AsksOfTheRootWhatTheRecursionInWorldAxesDoes) {
  for (uint64_t seed = 1; seed <= 100; ++seed) {
    Random random(seed);
    const Case c(seed == 1 ? Human37() : Build(RandomTreeSpec(&random)), seed);
    const FigureDynamics dynamics(c.figure);
    FigureScratch scratch = dynamics.MakeScratch();
    c.Torques(dynamics, &scratch);
    const Pose X_WR = c.moving_root.X_WR();
    const Wrench wrench = dynamics.RootWrench(X_WR, c.moving_root.Motion(), scratch);
    DynamicsWorkspace ws = c.Placed();
    InverseDynamics(c.figure, c.moving_root.Motion(), c.qd, c.qdd, &c.ends, &ws);
    EXPECT_LE(RelativeDifference(wrench.force, ws.bodies[0].f), 1e-12) << seed;
    EXPECT_LE(RelativeDifference(wrench.moment, ws.bodies[0].n), 1e-12) << seed;
  }
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
    ExpectLanesAgree(Case(Build(spec), seed), "seed " + std::to_string(seed));
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
      ExpectLanesAgree(Case(Build(spec), arms),
                       std::to_string(arms) + " x " + std::to_string(joints));
    }
  }
}

TEST(FigureDynamics, TakesALoadBetweenTheHingesOfAJoint) {
  const RigidInertia load{2.0, Vec3(0.1, 0.2, 0.3), 0.1 * Mat3::Identity()};
  for (const int joint : {0, 1, 2, 9, 10, 30, 36}) {
    ExpectLanesAgree(Case(Human37().WithLoad(JointIndex(joint), load), 5), std::to_string(joint));
  }
}

TEST(FigureDynamics, TakesLargeAngles) {
  Case c(Human37(), 8);
  c.q[3] += 2e5;
  c.q[20] -= 1e9;
  c.q[36] += 1e4;
  ExpectLanesAgree(c, "large angles");
}

TEST(FigureDynamics, TakesAFigureWithoutJoints) {
  FigureSpec spec = EmptySpec();
  spec.root_links = Joint("", "", {}, std::make_unique<Random>(1).get()).links;
  ExpectLanesAgree(Case(Build(spec), 1), "no joints");
}

TEST(FigureDynamics, GivesTheSameBitsWithEveryInstructionSet) {
  if (BestInstructions() == Instructions::kBaseline) GTEST_SKIP() << "only one here";
  for (uint64_t seed = 0; seed <= 50; ++seed) {
    Random random(seed);
    const Case c(seed == 0 ? Human37() : Build(RandomTreeSpec(&random)), seed);
    const FigureDynamics plain(c.figure, Instructions::kBaseline), best(c.figure);
    FigureScratch of_plain = plain.MakeScratch(), of_best = best.MakeScratch();
    EXPECT_EQ(c.Torques(plain, &of_plain), c.Torques(best, &of_best)) << "seed " << seed;
  }
}

TEST(FigureDynamics, KeepsNothingFromOneUseToTheNext) {
  const Case first(Human37(), 1), second(Human37(), 2);
  const FigureDynamics dynamics(first.figure);
  FigureScratch used = dynamics.MakeScratch(), fresh = dynamics.MakeScratch();
  (void)first.Torques(dynamics, &used);
  EXPECT_EQ(second.Torques(dynamics, &used), second.Torques(dynamics, &fresh));
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

TEST(FigureDynamics, OfChainsIsThatOfTheRecursionInWorldAxes) {
  for (const int joints : {1, 10, 100, 1000, 10000}) {
    Case c(Build(Chain(joints)), joints);
    c.q *= 0.1;
    c.qd *= 0.1;
    ExpectLanesAgree(c, std::to_string(joints));
  }
}

}  // namespace
}  // namespace hazumi::test
