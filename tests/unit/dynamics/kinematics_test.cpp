#include "engine/dynamics/kinematics.h"

#include <cmath>
#include <numbers>
#include <string>

#include "tests/support/compare.h"
#include "tests/support/figures.h"
#include "tests/support/path.h"

namespace hazumi::test {
namespace {

TEST(Kinematics, VelocitiesAreTheDerivativeOfPositions) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    const Path path(seed);
    for (int j = 0; j < path.figure().num_joints(); ++j) {
      const auto origin = [&](double t) { return path.At(t).bodies[j + 1].p; };
      EXPECT_LE(RelativeDifference(path.At(0.0).bodies[j + 1].v, Derivative(origin)), 1e-8)
          << "seed " << seed << " joint " << j;
    }
  }
}

TEST(Kinematics, AccelerationsAreTheDerivativeOfVelocities) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    const Path path(seed);
    for (int j = 0; j < path.figure().num_joints(); ++j) {
      const auto twist = [&](double t) {
        const DynamicsWorkspace ws = path.At(t);
        Vec6 both;
        both << ws.bodies[j + 1].w, ws.bodies[j + 1].v;
        return both;
      };
      Vec6 expected;
      expected << path.At(0.0).bodies[j + 1].alpha, path.At(0.0).bodies[j + 1].a;
      EXPECT_LE(RelativeDifference(Derivative(twist), expected), 1e-8)
          << "seed " << seed << " joint " << j;
    }
  }
}

TEST(Kinematics, CenterOfMassVelocityIsTheDerivativeOfTheCenterOfMass) {
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    const Path path(seed);
    const auto com = [&](double t) { return CenterOfMass(path.figure(), path.At(t)); };
    EXPECT_LE(
        RelativeDifference(CenterOfMassVelocity(path.figure(), path.At(0.0)), Derivative(com)),
        1e-8)
        << "seed " << seed;
  }
}

TEST(OriginJacobian, IsTheDerivativeOfTheOriginByEachAngle) {
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    const Path path(seed);
    const Figure& figure = path.figure();
    const DynamicsWorkspace now = path.At(0.0);
    const JointIndex last(figure.num_joints() - 1);
    for (int i = 0; i < figure.num_joints(); ++i) {
      const auto origin = [&](double t) { return path.WithAngleTurned(i, t).body(last).p; };
      const Vec3 J = OriginJacobian(figure, now, last, JointIndex(i));
      EXPECT_LE((J - Derivative(origin)).norm(), 1e-9) << "seed " << seed << " joint " << i;
    }
  }
}

// Hinges about z, 1 mm apart.
FigureSpec LongChain(int joints) {
  FigureSpec spec;
  spec.root_name = "root";
  for (int i = 0; i < joints; ++i) {
    JointSpec joint;
    joint.name = "j" + std::to_string(i);
    joint.parent = i == 0 ? "root" : "j" + std::to_string(i - 1);
    joint.offset = i == 0 ? Vec3::Zero() : Vec3(1e-3, 0.0, 0.0);
    joint.hinges = {{"", Vec3::UnitZ(), -1.0, 1.0}};
    joint.links = {{"", Vec3::Zero(), {1e-3, 0.0, 0.0}, 1e-3, 1e-3, {}, {}, {}, {}, {}}};
    spec.joints.push_back(joint);
  }
  return spec;
}

// 2,000 equal turns make a full circle: half way round the chain is one diameter away.
TEST(Kinematics, OfADeepChainFollowsTheCurveOfItsLinks) {
  const Figure chain = Build(LongChain(2000));
  DynamicsWorkspace ws(chain);
  const double angle = 2.0 * std::numbers::pi / 2000.0;
  ComputePositions(chain, Pose(), VecX::Constant(2000, angle), &ws);
  const double diameter = 1e-3 / std::sin(0.5 * angle);
  EXPECT_NEAR((ws.bodies[1001].p - ws.bodies[1].p).norm(), diameter, 1e-12);
  EXPECT_NEAR((ws.bodies[2000].p - ws.bodies[1].p).norm(), 1e-3, 1e-12);
}

}  // namespace
}  // namespace hazumi::test
