// What a region model consists of: islands, bodies, balls, locks, impacts.

#include "engine/region/region_model.h"

#include <Eigen/Cholesky>
#include <algorithm>

#include "tests/support/compare.h"
#include "tests/support/figures.h"
#include "tests/unit/region/model_case.h"

namespace hazumi::test {
namespace {

// Everything constant at angle zero.
ModelRequest AllConstant(const Figure& figure, RootCoupling coupling) {
  ModelRequest request;
  request.roles.assign(figure.num_joints() + kRootAngles, Role::kConstant);
  request.angles = VecX::Zero(figure.num_joints() + kRootAngles);
  request.coupling = coupling;
  return request;
}

// All hinges of the islands whose name begins so.
void Assign(const Figure& figure, const std::vector<const char*>& prefixes, Role role,
            ModelRequest* request) {
  for (int j = 0; j < figure.num_joints(); ++j) {
    for (const char* prefix : prefixes) {
      if (figure.joints()[j].name.starts_with(prefix)) request->roles[j] = role;
    }
  }
}

const std::vector<const char*> kArms = {"l_shoulder", "l_elbow", "l_wrist",
                                        "r_shoulder", "r_elbow", "r_wrist"};

TEST(RegionModel, TwoArmsOnAPrescribedTrunkAreTwoModelsOfThreeBodies) {
  const Figure human = Human37();
  ModelRequest request = AllConstant(human, RootCoupling::kPrescribed);
  Assign(human, {"spine", "chest"}, Role::kDriven, &request);
  Assign(human, kArms, Role::kFree, &request);
  const std::vector<RegionModel> models = CompileRegionModels(human, request);
  ASSERT_EQ(models.size(), 2u);
  for (const RegionModel& model : models) {
    EXPECT_EQ(model.num_free, 7);
    EXPECT_EQ(model.num_bodies, 3);
    EXPECT_NEAR(model.mass, 3.6, 1e-12);
    EXPECT_FALSE(model.root_answers);
    // Root, spine, chest, and three of the arm; no neck, no leg, no other arm.
    EXPECT_EQ(model.nodes.size(), 6u);
  }
}

TEST(RegionModel, InFlightTwoArmsAreOneModelWithTheRestOfTheFigureAsOneBody) {
  const Figure human = Human37();
  ModelRequest request = AllConstant(human, RootCoupling::kFlight);
  Assign(human, kArms, Role::kFree, &request);
  const std::vector<RegionModel> models = CompileRegionModels(human, request);
  ASSERT_EQ(models.size(), 1u);
  EXPECT_EQ(models[0].num_free, 14);
  EXPECT_EQ(models[0].num_bodies, 7);
  EXPECT_NEAR(models[0].mass, human.total_mass(), 1e-12);
  EXPECT_TRUE(models[0].root_answers);
}

TEST(RegionModel, InFlightDrivenLegsAreBodiesOfTheirOwn) {
  const Figure human = Human37();
  ModelRequest request = AllConstant(human, RootCoupling::kFlight);
  Assign(human, kArms, Role::kFree, &request);
  Assign(human, {"l_hip", "l_knee"}, Role::kDriven, &request);
  EXPECT_EQ(CompileRegionModels(human, request)[0].num_bodies, 9);
}

TEST(RegionModel, APinBeyondConstantAndDrivenJointsPrescribesTheRoot) {
  const Figure human = Human37();
  ModelRequest request = AllConstant(human, RootCoupling::kPinned);
  Assign(human, kArms, Role::kFree, &request);
  Assign(human, {"l_knee"}, Role::kDriven, &request);
  request.pin = *human.FindJoint("l_toe_y");
  const std::vector<RegionModel> models = CompileRegionModels(human, request);
  ASSERT_EQ(models.size(), 2u);
  EXPECT_EQ(models[0].num_bodies, 3);
  request.pin = *human.FindJoint("r_wrist_x");
  EXPECT_EQ(CompileRegionModels(human, request).size(), 1u);
}

// The pin stays where it is whatever its own hinge does.
TEST(RegionModel, APinnedJointThatIsFreeItselfDoesNotMakeTheRootAnswer) {
  const Figure human = Human37();
  ModelRequest request = AllConstant(human, RootCoupling::kPinned);
  Assign(human, {"l_toe"}, Role::kFree, &request);
  request.pin = *human.FindJoint("l_toe_y");
  const std::vector<RegionModel> models = CompileRegionModels(human, request);
  ASSERT_EQ(models.size(), 1u);
  EXPECT_FALSE(models[0].root_answers);
  EXPECT_EQ(models[0].num_bodies, 1);
}

TEST(RegionModel, ThreeFreeConcentricHingesAreABallAndFewerAreNot) {
  const Figure human = Human37();
  ModelRequest request = AllConstant(human, RootCoupling::kPrescribed);
  Assign(human, {"l_shoulder"}, Role::kFree, &request);
  const auto has_ball = [&] {
    const RegionModel model = CompileRegionModels(human, request)[0];
    return std::any_of(model.nodes.begin(), model.nodes.end(),
                       [](const ModelNode& node) { return node.is_ball; });
  };
  EXPECT_TRUE(has_ball());
  const int middle = human.FindJoint("l_shoulder_x")->value();
  request.roles[middle] = Role::kConstant;
  EXPECT_FALSE(has_ball());
  request.roles[middle] = Role::kDriven;
  EXPECT_FALSE(has_ball());
}

// Where the model's nodes are, the figure's joints are.
TEST(RegionModel, ListsTheJointsThatMoveWithItsNodes) {
  int listed = 0;
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    for (const RootCoupling coupling : {RootCoupling::kPrescribed, RootCoupling::kFlight}) {
      ModelCase c(seed, coupling, /*is_root_free=*/seed % 2 == 0);
      const Figure& figure = c.sample.figure;
      for (const RegionModel& model : CompileRegionModels(figure, c.request)) {
        EXPECT_TRUE(model.joints.empty());
      }
      c.request.lists_joints = true;
      const DynamicsWorkspace ws = c.sample.Placed();
      std::vector<int> times(figure.num_joints(), 0);
      for (const RegionModel& model : CompileRegionModels(figure, c.request)) {
        const RegionLayout layout(model, /*balls=*/false);
        NodeKinematics kinematics(model);
        VecX q(layout.num_hinges()), qd = VecX::Zero(layout.num_hinges());
        for (int i = 0; i < layout.num_hinges(); ++i) q[i] = c.q[layout.hinges()[i].coordinate];
        kinematics.Move(layout, c.driven, c.t, q.data(), qd.data(), 0, kinematics.size());
        for (const NodeJoint& seat : model.joints) {
          EXPECT_TRUE(model.nodes[seat.node].is_dynamic);
          if (!seat.joint.is_valid()) continue;
          ++times[seat.joint.value()];
          ++listed;
          const NodeMotion& node = kinematics.motion()[seat.node];
          const Vec3 p = node.p.eigen() + node.R.eigen() * seat.p_N;
          EXPECT_LE((p - ws.body(seat.joint).p + c.sample.moving_root.p).norm(), 1e-12) << seed;
          EXPECT_LE((node.R.eigen() * seat.R_NJ - ws.body(seat.joint).R).norm(), 1e-12) << seed;
        }
      }
      for (const JointIndex j : c.free) {
        const int least = figure.body(j).is_massless() ? 0 : 1;
        EXPECT_GE(times[j.value()], least) << seed;
        EXPECT_LE(times[j.value()], 1) << seed;
      }
    }
  }
  EXPECT_GE(listed, 500);
}

TEST(RegionModel, NothingFreeIsNoModel) {
  const Figure human = Human37();
  EXPECT_TRUE(CompileRegionModels(human, AllConstant(human, RootCoupling::kPrescribed)).empty());
}

// Velocity derivatives in the layout with some hinges locked, from the hinges' accelerations.
VecX MapUnlocked(const RegionDynamics& dynamics, const std::vector<char>& locked, const VecX& q,
                 const VecX& qd, const VecX& qdd) {
  const VecX mapped = MapToBalls(dynamics.model(), q, qd, qdd);
  std::vector<char> has_lock(dynamics.model().nodes.size(), 0);
  for (int i = 0; i < dynamics.num_hinges(); ++i) {
    has_lock[dynamics.hinges()[i].node] |= locked[i];
  }
  std::vector<double> some;
  for (int i = 0; i < dynamics.num_hinges(); ++i) {
    if (!locked[i]) some.push_back(has_lock[dynamics.hinges()[i].node] ? qdd[i] : mapped[i]);
  }
  return Eigen::Map<VecX>(some.data(), static_cast<int>(some.size()));
}

// Locked hinges stay; the others move as if those were constant.
TEST(RegionModel, LockingIsTheSameAsHoldingConstant) {
  for (uint64_t seed = 0; seed < 100; ++seed) {
    ModelCase c(seed, RootCoupling::kFlight, /*is_root_free=*/false);
    ModelCase held = c;
    for (const JointIndex j : c.free) {
      if (!c.sample.random.Chance(0.4)) continue;
      held.request.roles[j.value()] = Role::kConstant;
      c.qd[j.value()] = held.qd[j.value()] = 0.0;
    }
    RegionDynamics all = std::move(c.Models()[0]), less = std::move(held.Models()[0]);
    if (less.num_hinges() == 0) continue;
    const VecX less_qdd = HingeAccelerations(&less, c.t, Gather(less, c.q), Gather(less, c.qd));
    VecX qdd = VecX::Zero(all.num_hinges());
    std::vector<char> locked(all.num_hinges(), 0);
    for (int i = 0, k = 0; i < all.num_hinges(); ++i) {
      locked[i] = held.request.roles[all.hinges()[i].coordinate] == Role::kConstant;
      if (!locked[i]) qdd[i] = less_qdd[k++];
    }
    const VecX q = Gather(all, c.q), qd = Gather(all, c.qd);
    all.mode().layout.SetLocked(locked, q);
    const VecX actual = VelocityDerivatives(&all, c.t, q, qd);
    EXPECT_LE(RelativeDifference(actual, MapUnlocked(all, locked, q, qd, qdd)), 1e-10)
        << "seed " << seed;
  }
}

// The impulse of a pin that is stopped, against the whole figure's momentum.
TEST(RegionModel, ABlowAtThePinChangesRatesAsTheWholeFigureSays) {
  Worst worst("impulse");
  for (uint64_t seed = 0; seed < kSamples; ++seed) {
    const ModelCase c(seed, RootCoupling::kPinned, /*is_root_free=*/false);
    DynamicsWorkspace ws(c.sample.figure);
    RegionSystem system(c.sample.figure, c.free);
    PassiveState state = c.State();
    VecX expected;
    ASSERT_TRUE(system.RatesAfterPinning(state, c.request.pin, &ws, &expected));
    ComputePositions(c.sample.figure, state.X_WR, state.q, &ws);
    ComputeVelocities(c.sample.figure, state.root.w, state.root.v, state.qd, &ws);
    const Vec3 v_pin = ws.body(c.request.pin).v;
    VecX all = VecX::Zero(c.q.size());
    for (size_t i = 0; i < c.free.size(); ++i) all[c.free[i].value()] = expected[i];
    for (RegionDynamics& dynamics : c.Models()) {
      const VecX qd = Gather(dynamics, c.qd);
      HingeState start(Gather(dynamics, c.q), qd);
      start.pin_velocity = v_pin;
      const HingeEquations equations = dynamics.AssembleHinges(c.t, start);
      VecX impulse(dynamics.num_hinges());
      equations.StopPin(&impulse);
      const VecX after = qd + equations.M().llt().solve(impulse);
      const double scale = expected.lpNorm<Eigen::Infinity>();
      const double error = (after - Gather(dynamics, all)).lpNorm<Eigen::Infinity>() / scale;
      EXPECT_LE(worst(error), 1e-9) << "seed " << seed;
    }
  }
}

TEST(DrivenCurve, IsThePolynomialInTheSecondsSinceItsStart) {
  Random random(8);
  for (int i = 0; i < 100; ++i) {
    DrivenCurve curve;
    curve.start = random.Uniform(-1.0, 1.0);
    curve.degree = random.Integer(0, DrivenCurve::kMaxDegree);
    const double t = curve.start + random.Uniform(-1.0, 1.0), s = t - curve.start;
    double value = 0.0, rate = 0.0, acceleration = 0.0;
    for (int p = 0; p <= curve.degree; ++p) {
      curve.c[p] = random.Uniform(-3.0, 3.0);
      value += curve.c[p] * std::pow(s, p);
      if (p > 0) rate += p * curve.c[p] * std::pow(s, p - 1);
      if (p > 1) acceleration += p * (p - 1) * curve.c[p] * std::pow(s, p - 2);
    }
    const Jet x = curve.At(t);
    EXPECT_NEAR(x.v, value, 1e-12);
    EXPECT_NEAR(x.d, rate, 1e-11);
    EXPECT_NEAR(x.dd, acceleration, 1e-10);
  }
}

}  // namespace
}  // namespace hazumi::test
