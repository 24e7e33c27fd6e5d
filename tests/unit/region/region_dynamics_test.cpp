// The reduced models of regions against the equations of the whole figure, and against MuJoCo with
// Lagrange multipliers where the root turns freely.

#include "engine/region/region_dynamics.h"

#include <Eigen/Cholesky>

#include "tests/support/compare.h"
#include "tests/unit/region/model_case.h"
#include "tests/unit/region/multipliers.h"

namespace hazumi::test {
namespace {

constexpr double kTolerance = 1e-10;
constexpr double kMujocoTolerance = 1e-9;

// By Coordinate; zero where not free.
VecX WholeFigureAccelerations(const ModelCase& c) {
  DynamicsWorkspace ws(c.sample.figure);
  RegionSystem system(c.sample.figure, c.free);
  system.Evaluate(c.State(), c.request.coupling, c.request.pin, ModelCase::kGravity, &ws);
  const VecX free = system.M().llt().solve(-system.b());
  VecX all = VecX::Zero(c.q.size());
  for (size_t i = 0; i < c.free.size(); ++i) all[c.free[i].value()] = free[i];
  return all;
}

// Of all models together, so that "relative" means the same for a small island and a large one.
struct Joined {
  explicit Joined(const ModelCase& c) {
    for (RegionDynamics& dynamics : c.Models()) {
      const VecX q = Gather(dynamics, c.q), qd = Gather(dynamics, c.qd);
      Append(HingeAccelerations(&dynamics, c.t, q, qd), &hinges);
      Append(VelocityDerivatives(&dynamics, c.t, q, qd), &balls);
    }
  }
  static void Append(const VecX& more, VecX* all) {
    all->conservativeResize(all->size() + more.size());
    all->tail(more.size()) = more;
  }
  VecX hinges, balls;
};

void ExpectAgreement(const char* claim, RootCoupling coupling) {
  Worst worst(claim), worst_ball("balls");
  for (uint64_t seed = 0; seed < kSamples; ++seed) {
    const ModelCase c(seed, coupling, /*is_root_free=*/false);
    const VecX expected = WholeFigureAccelerations(c);
    const Joined actual(c);
    VecX hinges, balls;
    for (const RegionDynamics& dynamics : c.Models()) {
      const VecX part = Gather(dynamics, expected);
      Joined::Append(part, &hinges);
      Joined::Append(
          MapToBalls(dynamics.model(), Gather(dynamics, c.q), Gather(dynamics, c.qd), part),
          &balls);
    }
    ASSERT_EQ(hinges.size(), static_cast<int>(c.free.size())) << "seed " << seed;
    EXPECT_LE(worst(RelativeDifference(actual.hinges, hinges)), kTolerance) << "seed " << seed;
    EXPECT_LE(worst_ball(RelativeDifference(actual.balls, balls)), kTolerance) << "seed " << seed;
  }
}

TEST(RegionDynamics, OnAPrescribedRootAgreesWithTheWholeFigure) {
  ExpectAgreement("prescribed", RootCoupling::kPrescribed);
}

TEST(RegionDynamics, PinnedAgreesWithTheWholeFigure) {
  ExpectAgreement("pinned", RootCoupling::kPinned);
}

TEST(RegionDynamics, InFlightAgreesWithTheWholeFigure) {
  ExpectAgreement("flight", RootCoupling::kFlight);
}

// Accelerations of MuJoCo's coordinates where the root turns freely.
VecX WithFreeRoot(ModelCase& c) {
  MujocoFigure& mujoco = c.sample.mujoco;
  Multipliers system{mujoco.InertiaMatrix(), -mujoco.Bias(), {}, {}};
  const VecX given = c.sample.Join(c.sample.qdd);
  std::vector<char> is_given(given.size(), 1);
  std::fill_n(is_given.begin(), MujocoFigure::kRootDof, 0);
  for (const JointIndex j : c.free) is_given[MujocoFigure::kRootDof + j.value()] = 0;
  system.Prescribe(is_given, given);
  if (c.request.coupling == RootCoupling::kPinned) {
    system.Add(mujoco.OriginJacobian(c.request.pin), -mujoco.OriginBiasAcceleration(c.request.pin));
  }
  return system.Solve();
}

// The root's angular acceleration in its own frame.
Vec3 RootAlpha(const ModelCase& c, const VecX& mujoco_accelerations) {
  MovingRoot root = c.sample.moving_root;
  root.acceleration = mujoco_accelerations.segment<3>(3);
  return root.X_WR().R.transpose() * root.Motion().alpha;
}

void ExpectAgreementWithFreeRoot(const char* claim, RootCoupling coupling) {
  Worst worst(claim), worst_root("root");
  for (uint64_t seed = 0; seed < kSamples; ++seed) {
    ModelCase c(seed, coupling, /*is_root_free=*/true);
    const VecX expected = WithFreeRoot(c);
    std::vector<RegionDynamics> models = c.Models();
    ASSERT_EQ(models.size(), 1u) << "seed " << seed;
    RegionDynamics& dynamics = models[0];
    const VecX q = Gather(dynamics, c.q), qd = Gather(dynamics, c.qd);
    const VecX hinges = HingeAccelerations(&dynamics, c.t, q, qd);
    const VecX balls = VelocityDerivatives(&dynamics, c.t, q, qd);
    EXPECT_LE(worst(RelativeDifference(hinges.tail(c.free.size()), c.FreeRows(expected))),
              kMujocoTolerance)
        << "seed " << seed;
    const Vec3 alpha = RootAlpha(c, expected);
    EXPECT_LE(worst_root((balls.head<3>() - alpha).norm() / expected.lpNorm<Eigen::Infinity>()),
              kMujocoTolerance)
        << "seed " << seed;
    EXPECT_LE(worst(RelativeDifference(balls, MapToBalls(dynamics.model(), q, qd, hinges))),
              kMujocoTolerance)
        << "seed " << seed;
  }
}

TEST(RegionDynamics, InFlightWithTheRootTurningFreelyAgreesWithMultipliers) {
  ExpectAgreementWithFreeRoot("free flight", RootCoupling::kFlight);
}

TEST(RegionDynamics, PinnedWithTheRootTurningFreelyAgreesWithMultipliers) {
  ExpectAgreementWithFreeRoot("free pinned", RootCoupling::kPinned);
}

// Friction is an acceleration: of the hinges -c rate; a root that turns freely answers it so that
// no torque acts on the figure from outside.
TEST(RegionDynamics, FrictionSlowsHingesAndTheFreeRootAnswers) {
  for (uint64_t seed = 1; seed < 60; ++seed) {
    const ModelCase c(seed, RootCoupling::kFlight, /*is_root_free=*/true);
    VecX friction = VecX::Constant(c.q.size(), 2.5);
    friction.tail(kRootAngles).setZero();
    RegionDynamics plain = std::move(c.Models()[0]), slowed = std::move(c.Models(&friction)[0]);
    const VecX q = Gather(plain, c.q), qd = Gather(plain, c.qd);
    const VecX free = VelocityDerivatives(&plain, c.t, q, qd);
    const VecX change = VelocityDerivatives(&slowed, c.t, q, qd) - free;
    VecX y(plain.layout().state_size());
    plain.layout().Pack(q, qd, y.data());
    const VecX expected = -2.5 * y.tail(plain.layout().num_dofs());
    const int n = static_cast<int>(change.size()) - 3;
    EXPECT_LE((change.tail(n) - expected.tail(n)).norm(), 1e-10 * free.norm()) << "seed " << seed;
    // In hinge coordinates the same: M change has no component along the root.
    VecX hinge_change = VecX::Zero(n + 3);
    hinge_change.tail(n) = -2.5 * qd.tail(n);
    const HingeEquations equations = plain.AssembleHinges(c.t, {q, qd});
    const MatX& M = equations.M();
    hinge_change.head<3>() =
        M.topLeftCorner<3, 3>().llt().solve(-M.topRightCorner(3, n) * hinge_change.tail(n));
    const VecX zero_rates = VecX::Zero(n + 3);
    EXPECT_LE((change - MapToBalls(plain.model(), q, zero_rates, hinge_change)).norm(),
              1e-9 * free.norm())
        << "seed " << seed;
  }
}

// The figure flies, pushed on its pin: what large islands are solved by.
TEST(RegionDynamics, SolvesAGroupOnAPinByArticulatedBodiesAsTheDenseWay) {
  Worst worst("on a pin, by articulated bodies");
  int answering = 0;
  for (uint64_t seed = 0; seed < kSamples; ++seed) {
    const ModelCase c(seed, RootCoupling::kPinned, /*is_root_free=*/false);
    for (RegionDynamics& dynamics : c.Models()) {
      answering += dynamics.model().root_answers;
      const VecX q = Gather(dynamics, c.q), qd = Gather(dynamics, c.qd);
      const VecX dense = VelocityDerivatives(&dynamics, c.t, q, qd);
      dynamics.SetMostDense(0);
      const VecX articulated = VelocityDerivatives(&dynamics, c.t, q, qd);
      EXPECT_LE(worst(RelativeDifference(articulated, dense)), kTolerance) << "seed " << seed;
    }
  }
  EXPECT_GT(answering, kSamples / 10);
}

}  // namespace
}  // namespace hazumi::test
