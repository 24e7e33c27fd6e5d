#include "engine/placement/hold_solver.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <deque>
#include <random>

#include "engine/dynamics/kinematics.h"
#include "tests/support/stick_figures.h"

namespace hazumi {
namespace {

using Random = std::mt19937;

double Uniform(double low, double high, Random* random) {
  return std::uniform_real_distribution<double>(low, high)(*random);
}

// A figure with one held joint, at rest.
struct Rig {
  Figure figure;
  GroupIndex held;
  HoldSolver solver;
  DynamicsWorkspace ws;
  bool with_orientation;

  Rig(Figure f, const char* joint, bool orientation)
      : figure(std::move(f)),
        held(*figure.FindGroup(joint)),
        solver(figure, IkHold{held, 0, 0, orientation, HoldReach::kBody}),
        ws(figure),
        with_orientation(orientation) {}

  JointIndex held_joint() const { return figure.group(held).first; }
  int dof() const { return static_cast<int>(solver.joints().size()); }

  HoldTarget TargetAt(const Pose& X_WR, const VecX& q) {
    ComputePositions(figure, X_WR, q, &ws);
    return {ws.body(held_joint()).p, ws.body(figure.joint(held_joint()).parent).R};
  }
  // Position error, and rotation vector of the orientation error if that is held.
  VecX Residual(const Pose& X_WR, const VecX& q, const HoldTarget& target) {
    const HoldTarget there = TargetAt(X_WR, q);
    VecX c(with_orientation ? 6 : 3);
    c.head<3>() = there.position - target.position;
    const Eigen::AngleAxisd turn(Mat3(there.orientation * target.orientation.transpose()));
    if (with_orientation) c.tail<3>() = turn.angle() * turn.axis();
    return c;
  }
};

PoseOf<Jet> Still(const Pose& X) { return {X.R.cast<Jet>(), X.p.cast<Jet>()}; }

std::vector<Jet> Jets(const VecX& q) { return std::vector<Jet>(q.data(), q.data() + q.size()); }

VecX Values(const std::vector<Jet>& jets) {
  VecX q(jets.size());
  for (size_t i = 0; i < jets.size(); ++i) q[i] = jets[i].v;
  return q;
}

struct Solved {
  HoldSolution solution;
  VecX q;
};
Solved Solve(Rig& rig, const Pose& X_WR, const HoldTarget& target, const VecX& keyed) {
  std::vector<Jet> q = Jets(keyed);
  const HoldSolution solution = rig.solver.Solve(Still(X_WR), target, &q);
  return {solution, Values(q)};
}

// Natural poses: nothing straight, no hinges lined up.
VecX NaturalPose(const Figure& figure, Random* random) {
  VecX q(figure.num_joints());
  for (int j = 0; j < q.size(); ++j) q[j] = Uniform(-0.6, 0.6, random);
  for (const char* bend : {"knee", "elbow_y"}) {
    if (const auto j = figure.FindJoint(bend)) q[j->value()] = Uniform(0.3, 1.5, random);
  }
  return q;
}

VecX Perturbed(const VecX& q, double by, Random* random) {
  VecX other = q;
  for (double& angle : other) angle += Uniform(-by, by, random);
  return other;
}

// A deque, because the solvers point to their figures.
std::deque<Rig> AllRigs() {
  std::deque<Rig> rigs;
  for (const bool orientation : {false, true}) {
    rigs.emplace_back(test::Leg(), "toe", orientation);
    rigs.emplace_back(test::Arm(), "tip", orientation);
  }
  return rigs;
}

TEST(HoldSolver, SolvesWhatLiesBetweenRootAndHeldJoint) {
  const Rig rig(test::Leg(), "toe", true);
  EXPECT_EQ(rig.dof(), 6);
  EXPECT_EQ(rig.solver.joints().back(), *rig.figure.FindJoint("ankle_x"));
}

TEST(HoldSolver, LeavesAKeyedPoseThatIsOnTheTargetAlone) {
  Random random(10);
  for (Rig& rig : AllRigs()) {
    const VecX keyed = NaturalPose(rig.figure, &random);
    const Solved solved = Solve(rig, Pose(), rig.TargetAt(Pose(), keyed), keyed);
    ASSERT_TRUE(solved.solution.reached);
    EXPECT_LE((solved.q - keyed).cwiseAbs().maxCoeff(), 1e-12);
  }
}

// Whole figures off by `by` [rad] in every joint: returns how many of `count` were not reached.
int CountFailures(Rig* rig, int count, double by, Random* random) {
  int failures = 0;
  for (int i = 0; i < count; ++i) {
    const VecX goal = NaturalPose(rig->figure, random);
    const HoldTarget target = rig->TargetAt(Pose(), goal);
    const Solved solved = Solve(*rig, Pose(), target, Perturbed(goal, by, random));
    failures += !solved.solution.reached;
    if (!solved.solution.reached) continue;
    EXPECT_LE(rig->Residual(Pose(), solved.q, target).cwiseAbs().maxCoeff(), 1e-12);
  }
  return failures;
}

TEST(HoldSolver, ReachesEveryReachableTarget) {
  Random random(11);
  for (const double by : {0.05, 0.3, 0.6}) {
    for (Rig& rig : AllRigs()) {
      EXPECT_EQ(CountFailures(&rig, 2000, by, &random), 0)
          << rig.figure.groups().back().name << (rig.with_orientation ? " turned too" : "")
          << ", keys off by " << by;
    }
  }
}

// Projects q back onto the constraint by Gauss and Newton with numeric derivatives.
bool Project(Rig* rig, const HoldTarget& target, VecX* q) {
  constexpr double h = 1e-6;
  for (int i = 0; i < 30; ++i) {
    const VecX c = rig->Residual(Pose(), *q, target);
    if (c.norm() < 1e-11) return true;
    MatX J(c.size(), rig->dof());
    for (int k = 0; k < rig->dof(); ++k) {
      VecX there = *q;
      there[rig->solver.joints()[k].value()] += h;
      J.col(k) = (rig->Residual(Pose(), there, target) - c) / h;
    }
    const VecX step = J.completeOrthogonalDecomposition().solve(c);
    for (int k = 0; k < rig->dof(); ++k) (*q)[rig->solver.joints()[k].value()] -= step[k];
  }
  return false;
}

TEST(HoldSolver, IsTheNearestToTheKeyedPose) {
  Random random(12);
  for (Rig& rig : AllRigs()) {
    for (int i = 0; i < 20; ++i) {
      const VecX goal = NaturalPose(rig.figure, &random);
      const HoldTarget target = rig.TargetAt(Pose(), goal);
      const VecX keyed = Perturbed(goal, 0.2, &random);
      const Solved solved = Solve(rig, Pose(), target, keyed);
      ASSERT_TRUE(solved.solution.reached);
      const double distance = (solved.q - keyed).norm();
      for (const double by : {0.003, 0.03, 0.3}) {
        VecX other = solved.q;
        for (const JointIndex j : rig.solver.joints()) {
          other[j.value()] += Uniform(-by, by, &random);
        }
        if (!Project(&rig, target, &other)) continue;
        EXPECT_GE((other - keyed).norm(), distance - 1e-9) << "moved by " << by;
      }
    }
  }
}

TEST(HoldSolver, KeyedPosePicksTheBranch) {
  for (const double side : {-1.0, 1.0}) {
    Rig rig(test::Leg(), "toe", false);
    VecX keyed = VecX::Zero(rig.figure.num_joints());
    keyed[rig.figure.FindJoint("knee")->value()] = side * 0.8;
    keyed[rig.figure.FindJoint("hip_y")->value()] = -side * 0.4;
    const Solved solved = Solve(rig, Pose(), {Vec3(0.1, 0.02, -0.8), Mat3()}, keyed);
    ASSERT_TRUE(solved.solution.reached);
    EXPECT_GT(side * solved.q[rig.figure.FindJoint("knee")->value()], 0.3);
  }
}

// Root and keyed angles that move and accelerate.
struct Moving {
  VecX q0, q1, q2;
  PoseOf<Jet> RootAt(const Jet& t) const {
    PoseOf<Jet> X;
    const Jet z = 0.3 * t + 0.5 * t * t, x = -0.4 * t + 0.1;
    X.R = AxisRotation<Jet>(Vec3::UnitZ(), sin(z), cos(z)) *
          AxisRotation<Jet>(Vec3::UnitX(), sin(x), cos(x));
    X.p << 0.1 * t, 0.05 * t * t, -0.08 * t + 0.2 * t * t;
    return X;
  }
  std::vector<Jet> KeyedAt(const Jet& t) const {
    std::vector<Jet> q;
    for (int j = 0; j < q0.size(); ++j) q.push_back(q0[j] + q1[j] * t + q2[j] * t * t);
    return q;
  }
};

std::vector<Jet> SolvedAt(Rig& rig, const Moving& moving, const HoldTarget& target, const Jet& t) {
  std::vector<Jet> q = moving.KeyedAt(t);
  EXPECT_TRUE(rig.solver.Solve(moving.RootAt(t), target, &q).reached);
  return q;
}

VecX PositionsAt(Rig& rig, const Moving& moving, const HoldTarget& target, double t) {
  return Values(SolvedAt(rig, moving, target, Jet(t)));
}

void ExpectExactRates(Rig* rig, const Moving& moving, const HoldTarget& target) {
  const std::vector<Jet> jets = SolvedAt(*rig, moving, target, Jet(0.0, 1.0, 0.0));
  const VecX at = Values(jets);
  const auto rate = [&](double h) -> VecX {
    return (PositionsAt(*rig, moving, target, h) - PositionsAt(*rig, moving, target, -h)) / (2 * h);
  };
  const auto acceleration = [&](double h) -> VecX {
    return (PositionsAt(*rig, moving, target, h) - 2.0 * at +
            PositionsAt(*rig, moving, target, -h)) /
           (h * h);
  };
  const VecX d = (4.0 * rate(5e-4) - rate(1e-3)) / 3.0;
  const VecX dd = (4.0 * acceleration(1e-3) - acceleration(2e-3)) / 3.0;
  for (int j = 0; j < at.size(); ++j) {
    EXPECT_NEAR(jets[j].d, d[j], 1e-7 * (1.0 + std::abs(d[j])));
    EXPECT_NEAR(jets[j].dd, dd[j], 1e-6 * (1.0 + std::abs(dd[j])));
  }
}

TEST(HoldSolver, RatesAndAccelerationsAreTheDerivativesOfTheAngles) {
  Random random(13);
  for (Rig& rig : AllRigs()) {
    for (int i = 0; i < 10; ++i) {
      const VecX goal = NaturalPose(rig.figure, &random);
      const VecX zero = VecX::Zero(goal.size());
      const Moving moving{Perturbed(goal, 0.1, &random), Perturbed(zero, 1.0, &random),
                          Perturbed(zero, 1.0, &random)};
      const PoseOf<Jet> root = moving.RootAt(Jet(0.0));
      const auto value = [](const Jet& jet) { return jet.v; };
      const Pose X_WR{root.R.unaryExpr(value), root.p.unaryExpr(value)};
      ExpectExactRates(&rig, moving, rig.TargetAt(X_WR, goal));
    }
  }
}

// Thigh, shank and foot in one line.
TEST(HoldSolver, SaysHowFarATargetIsOutOfReach) {
  Rig rig(test::Leg(), "toe", false);
  const double reach = 0.4 + 0.4 + std::hypot(0.15, 0.07);
  Random random(14);
  for (int i = 0; i < 20; ++i) {
    const VecX keyed = NaturalPose(rig.figure, &random);
    const Vec3 hip(0.0, 0.0, -0.05);
    const Vec3 away = Vec3(Uniform(-0.5, 0.5, &random), Uniform(-0.5, 0.5, &random), -1.0);
    const Vec3 target = hip + (reach + 0.07) * away.normalized();
    const Solved solved = Solve(rig, Pose(), {target, Mat3::Identity()}, keyed);
    EXPECT_FALSE(solved.solution.reached);
    EXPECT_NEAR(solved.solution.distance, 0.07, 1e-6);
  }
}

// The foot stays level, so that its ankle is the end of the chain.
TEST(HoldSolver, SaysHowFarATargetWithOrientationIsOutOfReach) {
  Rig rig(test::Leg(), "toe", true);
  Random random(15);
  for (int i = 0; i < 20; ++i) {
    const VecX keyed = NaturalPose(rig.figure, &random);
    const Vec3 ankle(0.0, 0.0, -0.05 - 0.8 - 0.06);
    const HoldTarget target{ankle + Vec3(0.15, 0.0, -0.07), Mat3::Identity()};
    const Solved solved = Solve(rig, Pose(), target, keyed);
    EXPECT_FALSE(solved.solution.reached);
    EXPECT_NEAR(solved.solution.distance, 0.06, 1e-4);
  }
}

// A straight leg has no first-order way to get shorter.
TEST(HoldSolver, BendsAStraightLeg) {
  for (const bool orientation : {false, true}) {
    Rig rig(test::Leg(), "toe", orientation);
    const VecX straight = VecX::Zero(rig.figure.num_joints());
    HoldTarget target = rig.TargetAt(Pose(), straight);
    for (const double by : {1e-6, 1e-3, 0.03, 0.2}) {
      const HoldTarget higher{target.position + Vec3(0.0, 0.0, by), target.orientation};
      const Solved solved = Solve(rig, Pose(), higher, straight);
      ASSERT_TRUE(solved.solution.reached) << by << " m, orientation " << orientation;
      EXPECT_LE(rig.Residual(Pose(), solved.q, higher).cwiseAbs().maxCoeff(), 1e-12);
    }
  }
}

TEST(HoldSolver, KeepsAStraightLegsRatesFinite) {
  Rig rig(test::Leg(), "toe", true);
  const VecX straight = VecX::Zero(rig.figure.num_joints());
  const HoldTarget target = rig.TargetAt(Pose(), straight);
  PoseOf<Jet> X_WR;
  X_WR.p = Vec3Of<Jet>(Jet(0.0, 0.1, 0.0), Jet(0.0), Jet(0.0));
  std::vector<Jet> q = Jets(straight);
  ASSERT_TRUE(rig.solver.Solve(X_WR, target, &q).reached);
  for (const Jet& jet : q) EXPECT_TRUE(std::isfinite(jet.d) && std::isfinite(jet.dd));
}

TEST(HoldSolver, GivesTheSameBitsWhateverWasSolvedBefore) {
  Random random(16);
  Rig rig(test::Arm(), "tip", true), fresh(test::Arm(), "tip", true);
  for (int i = 0; i < 10; ++i) {
    const VecX goal = NaturalPose(rig.figure, &random);
    const VecX keyed = Perturbed(goal, 0.3, &random);
    const HoldTarget target = rig.TargetAt(Pose(), goal);
    Solve(rig, Pose(), {Vec3(9.0, 9.0, 9.0), Mat3::Identity()}, keyed);
    EXPECT_EQ(Solve(rig, Pose(), target, keyed).q, Solve(fresh, Pose(), target, keyed).q);
  }
}

}  // namespace
}  // namespace hazumi
