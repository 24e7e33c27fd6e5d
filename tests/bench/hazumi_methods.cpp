// Our own ways to swing. To add one: another function here, and its name in HazumiMethods.

#include <limits>

#include "engine/passive/paper_step.h"
#include "engine/passive/region_system.h"
#include "tests/bench/subject.h"
#include "tests/bench/swing_method.h"

namespace hazumi::bench {

namespace {

std::vector<JointIndex> AllJoints(const Figure& figure) {
  std::vector<JointIndex> all;
  for (int j = 0; j < figure.num_joints(); ++j) all.emplace_back(j);
  return all;
}

// The step as printed [Arai 2.4], with everything it needs made once.
class PaperSwing {
 public:
  explicit PaperSwing(const Figure& figure)
      : ws_(figure), system_(figure, AllJoints(figure)), step_(figure.num_joints()) {}

  VecX Run(const SwingCase& c, double steps) {
    const double h = c.seconds / steps;
    PaperStepInput input{&system_.M(), &system_.b(), c.friction, c.lower, c.upper};
    for (double& f : input.friction) f = FrictionOfStep(f, h);
    PassiveState state{Pose(), RootMotion(), c.q, c.qd, VecX::Zero(c.q.size())};
    for (int i = 0; i < steps; ++i) {
      system_.Evaluate(state, RootCoupling::kPrescribed, JointIndex(), kGravity, &ws_);
      if (step_.Advance(input, h, &state.q, &state.qd) != PaperStepStatus::kOk) {
        return VecX::Constant(c.q.size(), std::numeric_limits<double>::infinity());
      }
    }
    return state.q;
  }

 private:
  DynamicsWorkspace ws_;
  RegionSystem system_;
  PaperStep step_;
};

SwingMethod PaperMethod(const Figure& arm) {
  const auto swing = std::make_shared<PaperSwing>(arm);
  return {"hazumi_paper",
          "steps",
          {10, 20, 50, 100, 300, 1000, 3000, 10000, 30000},
          [](const SwingCase&) { return true; },
          [swing](const SwingCase& c, double steps) { return swing->Run(c, steps); }};
}

}  // namespace

std::vector<SwingMethod> HazumiMethods(const Figure& arm) { return {PaperMethod(arm)}; }

}  // namespace hazumi::bench
