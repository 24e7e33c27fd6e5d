#include <gtest/gtest.h>

#include "engine/dynamics/inverse_dynamics.h"
#include "engine/region/exact/exact_solver.h"
#include "engine/region/forces/force_spec.h"
#include "engine/region/paper_step.h"
#include "engine/region/region_system.h"
#include "tests/support/allocation_count.h"
#include "tests/support/figures.h"
#include "tests/support/random_tree.h"

namespace hazumi::test {
namespace {

// Everything an evaluation on the human needs, made beforehand.
class NoAllocation : public ::testing::Test {
 protected:
  NoAllocation() : figure_(Human37()), ws_(figure_) {
    Random random(1);
    q_ = RandomAngles(figure_, &random);
    qd_ = random.Vector(figure_.num_joints(), 1.0);
    qdd_ = qd_;
    ends_ = RandomEndForces(figure_, &random);
    ComputePositions(figure_, Pose(), q_, &ws_);
  }

  void SetUp() override {
    if (!CanCountAllocations()) GTEST_SKIP() << "not here: a sanitizer owns malloc";
  }

  // Once to let scratch that is sized at first use be sized, then counted.
  template <typename Evaluate>
  void ExpectNone(const Evaluate& evaluate) {
    evaluate();
    const long before = AllocationCount();
    evaluate();
    const long after = AllocationCount();
    EXPECT_EQ(after - before, 0);
  }

  const Figure figure_;
  DynamicsWorkspace ws_;
  VecX q_, qd_, qdd_;
  EndForces ends_;
  RootMotion root_;
};

TEST_F(NoAllocation, TheCounterCounts) {
  const long before = AllocationCount();
  const VecX x(100);
  const auto y = std::make_unique<double>(x.size());
  EXPECT_EQ(AllocationCount() - before, 2);
}

TEST_F(NoAllocation, InKinematics) {
  ExpectNone([&] {
    ComputePositions(figure_, Pose(), q_, &ws_);
    ComputeMotion(figure_, root_, qd_, qdd_, &ws_);
    (void)CenterOfMass(figure_, ws_);
  });
}

TEST_F(NoAllocation, InInverseDynamics) {
  ExpectNone([&] { InverseDynamics(figure_, root_, qd_, qdd_, &ends_, &ws_); });
}

TEST_F(NoAllocation, InAColumnOfTheInertiaMatrix) {
  ExpectNone([&] { UnitAccelerationTorques(figure_, JointIndex(30), &ws_); });
}

std::vector<JointIndex> AllJoints(const Figure& figure) {
  std::vector<JointIndex> all;
  for (int j = 0; j < figure.num_joints(); ++j) all.emplace_back(j);
  return all;
}

TEST_F(NoAllocation, InARegionSystem) {
  RegionSystem system(figure_, AllJoints(figure_));
  const PassiveState state{Pose(), root_, q_, qd_, qdd_};
  for (const RootCoupling coupling :
       {RootCoupling::kPrescribed, RootCoupling::kPinned, RootCoupling::kFlight}) {
    ExpectNone([&] { system.Evaluate(state, coupling, JointIndex(36), 9.81, &ws_); });
  }
}

TEST_F(NoAllocation, InThePapersStep) {
  RegionSystem system(figure_, AllJoints(figure_));
  const int n = figure_.num_joints();
  system.Evaluate({Pose(), root_, q_, qd_, qdd_}, RootCoupling::kPrescribed, {}, 9.81, &ws_);
  PaperStep step(n);
  // Limits so tight that the set of corrected joints has to grow.
  const VecX ones = VecX::Ones(n), lower = q_ - 1e-4 * ones, upper = q_ + 1e-4 * ones;
  const PaperStepInput input{&system.M(), &system.b(), 0.9 * ones, lower, upper};
  ExpectNone([&] { ASSERT_EQ(step.Advance(input, 1.0 / 300.0, &q_, &qd_), PaperStepStatus::kOk); });
  EXPECT_GT(step.solves(), 1);
}

// A swing against limits, looks inside its steps included.
TEST_F(NoAllocation, InStepsOfTheExactMethod) {
  constexpr int kShoulder = 9, kArm = 7;  // the right arm's hinges
  const int n = figure_.num_joints();
  ModelRequest request;
  request.roles.assign(n + kRootAngles, Role::kConstant);
  request.angles = VecX::Zero(n + kRootAngles);
  std::fill_n(request.roles.begin() + kShoulder, kArm, Role::kFree);
  const RegionModel model = CompileRegionModels(figure_, request).at(0);
  RegionDynamics dynamics(model, FrictionAlone(VecX::Constant(kArm, 1.0)), 9.81);
  DrivenMotion driven;
  driven.angles.resize(n + kRootAngles);
  dynamics.SetDriven(&driven, 0.0, 10.0);
  const VecX limits = VecX::Constant(kArm, 0.5);
  ExactSolver solver(&dynamics, -limits, limits);
  HingeState state(VecX::Constant(kArm, 0.3), VecX::Constant(kArm, 1.0));
  solver.Start(0.0, state);
  ExpectNone([&] {
    for (int step = 0; step < 60; ++step) {
      ASSERT_FALSE(solver.Advance(10.0));
      solver.Sample(0.5 * (solver.step_start() + solver.time()), &state);
    }
  });
}

}  // namespace
}  // namespace hazumi::test
