// The free joints' equation of motion against Lagrange multipliers: MuJoCo's inertia matrix and
// bias of the figure on a root with six degrees of freedom, bordered by what is prescribed or
// pinned.

#include "engine/region/region_system.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <limits>

#include "tests/support/compare.h"
#include "tests/support/sample.h"
#include "tests/unit/region/multipliers.h"

namespace hazumi::test {
namespace {

constexpr double kGravity = 9.81;
constexpr double kSystemTolerance = 1e-9;
constexpr double kNotRead = std::numeric_limits<double>::quiet_NaN();

// A sample of which some joints are free.
struct Region {
  explicit Region(uint64_t seed) : sample(seed, Root::kMoving, Vec3(0, 0, -kGravity)) {
    const int n = sample.figure.num_joints();
    const double share = sample.random.Uniform(0.2, 1.0);
    for (int j = 0; j < n; ++j) {
      if (sample.random.Chance(share)) free.emplace_back(j);
    }
    if (free.empty()) free.emplace_back(n - 1);
    pin = JointIndex(sample.random.Integer(0, n - 1));
  }

  PassiveState State(RootCoupling coupling) const {
    PassiveState state{sample.moving_root.X_WR(), sample.moving_root.Motion(), sample.q, sample.qd,
                       sample.qdd};
    if (coupling != RootCoupling::kPrescribed) state.root.a.setConstant(kNotRead);
    for (const JointIndex j : free) state.qdd[j.value()] = kNotRead;
    return state;
  }

  VecX FreeRows(const VecX& all) const {
    VecX rows(free.size());
    for (size_t i = 0; i < free.size(); ++i) {
      rows[i] = all[MujocoFigure::kRootDof + free[i].value()];
    }
    return rows;
  }

  Sample sample;
  std::vector<JointIndex> free;
  JointIndex pin;
};

// All coordinates that are prescribed keep the given values.
void Prescribe(const Region& region, bool translation, const VecX& values, Multipliers* system) {
  std::vector<char> is_given(values.size(), 1);
  if (!translation) std::fill_n(is_given.begin(), 3, 0);
  for (const JointIndex j : region.free) is_given[MujocoFigure::kRootDof + j.value()] = 0;
  system->Prescribe(is_given, values);
}

VecX ExpectedAccelerations(Region& region, RootCoupling coupling) {
  MujocoFigure& mujoco = region.sample.mujoco;
  Multipliers system{mujoco.InertiaMatrix(), -mujoco.Bias(), {}, {}};
  Prescribe(region, coupling == RootCoupling::kPrescribed, region.sample.Join(region.sample.qdd),
            &system);
  if (coupling == RootCoupling::kPinned) {
    system.Add(mujoco.OriginJacobian(region.pin), -mujoco.OriginBiasAcceleration(region.pin));
  }
  return region.FreeRows(system.Solve());
}

VecX ActualAccelerations(const Region& region, RootCoupling coupling) {
  const Figure& figure = region.sample.figure;
  DynamicsWorkspace ws(figure);
  RegionSystem system(figure, region.free);
  system.Evaluate(region.State(coupling), coupling, region.pin, kGravity, &ws);
  return system.M().llt().solve(-system.b());
}

void ExpectSameSystem(const char* claim, RootCoupling coupling) {
  Worst worst(claim);
  for (uint64_t seed = 0; seed < kSamples; ++seed) {
    Region region(seed);
    const VecX expected = ExpectedAccelerations(region, coupling);
    EXPECT_LE(worst(RelativeDifference(ActualAccelerations(region, coupling), expected)),
              kSystemTolerance)
        << "seed " << seed;
  }
}

TEST(RegionSystem, OnAPrescribedRootAgreesWithMultipliers) {
  ExpectSameSystem("prescribed", RootCoupling::kPrescribed);
}

TEST(RegionSystem, PinnedAgreesWithMultipliers) {
  ExpectSameSystem("pinned", RootCoupling::kPinned);
}

TEST(RegionSystem, InFlightAgreesWithMultipliers) {
  ExpectSameSystem("flight", RootCoupling::kFlight);
}

TEST(RegionSystem, RatesAfterPinningAgreeWithTheImpulseOfMultipliers) {
  Worst worst("impulse");
  for (uint64_t seed = 0; seed < kSamples; ++seed) {
    Region region(seed);
    const Sample& sample = region.sample;
    MujocoFigure& mujoco = region.sample.mujoco;
    const VecX before =
        MujocoFigure::Join(sample.moving_root.v, sample.moving_root.rate, sample.qd);
    const MatX M = mujoco.InertiaMatrix();
    Multipliers impulse{M, M * before, {}, {}};
    Prescribe(region, false, before, &impulse);
    impulse.Add(mujoco.OriginJacobian(region.pin), Vec3::Zero());
    DynamicsWorkspace ws(sample.figure);
    RegionSystem system(sample.figure, region.free);
    VecX rates;
    ASSERT_TRUE(
        system.RatesAfterPinning(region.State(RootCoupling::kPinned), region.pin, &ws, &rates));
    EXPECT_LE(worst(RelativeDifference(rates, region.FreeRows(impulse.Solve()))), kSystemTolerance)
        << "seed " << seed;
  }
}

TEST(RegionSystem, PinningARootThatAlreadyKeepsThePinStillChangesNoRate) {
  const Figure human = Human37();
  const JointIndex toe = *human.FindJoint("l_toe_y");
  Random random(4);
  PassiveState state{Pose(), RootMotion(), RandomAngles(human, &random), random.Vector(37, 3.0),
                     VecX::Zero(37)};
  state.root.w = random.Vector3(2.0);
  DynamicsWorkspace ws(human);
  ComputePositions(human, state.X_WR, state.q, &ws);
  ComputeVelocities(human, state.root.w, Vec3::Zero(), state.qd, &ws);
  state.root.v = -ws.body(toe).v;
  std::vector<JointIndex> free;
  for (const int j : {5, 11, 13, 25, 26}) free.emplace_back(j);
  VecX rates;
  RegionSystem system(human, free);
  ASSERT_TRUE(system.RatesAfterPinning(state, toe, &ws, &rates));
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(rates[i], state.qd[free[i].value()], 1e-11) << i;
}

TEST(RegionSystem, ArmsThatHangFromAPrescribedTrunkDoNotFeelEachOther) {
  const Figure human = Human37();
  std::vector<JointIndex> arms;
  for (int j = 9; j < 23; ++j) arms.emplace_back(j);
  Random random(5);
  const PassiveState state{Pose(), RootMotion(), RandomAngles(human, &random),
                           random.Vector(37, 3.0), VecX::Zero(37)};
  DynamicsWorkspace ws(human);
  RegionSystem system(human, arms);
  system.Evaluate(state, RootCoupling::kPrescribed, JointIndex(), kGravity, &ws);
  EXPECT_TRUE(system.M().topRightCorner(7, 7).isZero(0.0));
  EXPECT_TRUE(system.M().bottomLeftCorner(7, 7).isZero(0.0));
}

}  // namespace
}  // namespace hazumi::test
