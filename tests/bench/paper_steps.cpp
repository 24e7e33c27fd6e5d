#include <limits>
#include <memory>

#include "engine/region/paper_step.h"
#include "engine/region/region_system.h"
#include "tests/bench/step_method.h"
#include "tests/bench/subject.h"
#include "tests/support/energy.h"

namespace hazumi::bench {

namespace {

std::vector<JointIndex> AllJoints(const Figure& figure) {
  std::vector<JointIndex> all;
  for (int j = 0; j < figure.num_joints(); ++j) all.emplace_back(j);
  return all;
}

// Without friction and limits.
class FreePaperSwing {
 public:
  explicit FreePaperSwing(const Figure& figure)
      : figure_(figure), ws_(figure), system_(figure, AllJoints(figure)), step_(system_.size()) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    const VecX one = VecX::Ones(system_.size());
    input_ = {&system_.M(), &system_.b(), one, -kFar * one, kFar * one};
  }

  double EnergyAfterASecond(const VecX& q, const VecX& qd, int steps) {
    PassiveState state{Pose(), RootMotion(), q, qd, VecX::Zero(q.size())};
    for (int i = 0; i < steps; ++i) {
      system_.Evaluate(state, RootCoupling::kPrescribed, JointIndex(), kGravity, &ws_);
      if (step_.Advance(input_, 1.0 / steps, &state.q, &state.qd) != PaperStepStatus::kOk) {
        return std::numeric_limits<double>::quiet_NaN();
      }
    }
    return test::EnergyOf(figure_, state.q, state.qd, kGravity);
  }

 private:
  const Figure& figure_;
  DynamicsWorkspace ws_;
  RegionSystem system_;
  PaperStep step_;
  PaperStepInput input_;
};

}  // namespace

std::vector<StepMethod> PaperStepMethods(const Figure& arm) {
  const auto swing = std::make_shared<FreePaperSwing>(arm);
  return {{"hazumi_paper", 1, [swing](const VecX& q, const VecX& qd, int steps) {
             return swing->EnergyAfterASecond(q, qd, steps);
           }}};
}

}  // namespace hazumi::bench
