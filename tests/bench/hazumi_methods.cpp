// Our own ways to swing. To add one: another function here, and its name in HazumiMethods.

#include <limits>
#include <memory>
#include <string>

#include "engine/region/exact/exact_solver.h"
#include "engine/region/forces/force_spec.h"
#include "engine/region/paper_step.h"
#include "engine/region/region_system.h"
#include "tests/bench/stopwatch.h"
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
          [swing](const SwingCase& c, double steps) { return swing->Run(c, steps); },
          [&arm](const SwingCase&) { KeepAlive(PaperSwing(arm)); }};
}

// The solver of exact regions, with everything it needs made once. Settings are the tolerances of
// single steps.
class ExactSwing {
 public:
  explicit ExactSwing(const Figure& figure) {
    const int n = figure.num_joints();
    still_.angles.resize(n + kRootAngles);
    request_.roles.assign(n, Role::kFree);
    request_.roles.resize(n + kRootAngles, Role::kConstant);
    request_.angles = VecX::Zero(n + kRootAngles);
    model_ = CompileRegionModels(figure, request_).front();
  }

  VecX Run(const SwingCase& c, double tolerance) {
    if (!solver_ || name_ != c.name) Prepare(c);
    solver_->SetTolerance(tolerance);
    solver_->Start(0.0, {c.q, c.qd});
    while (solver_->time() < c.seconds) {
      if (solver_->Advance(c.seconds)) {
        return VecX::Constant(c.q.size(), std::numeric_limits<double>::infinity());
      }
    }
    return solver_->now().q;
  }

  void Prepare(const SwingCase& c) {
    const VecX rates = -30.0 * c.friction.array().log();
    dynamics_ = std::make_unique<RegionDynamics>(model_, FrictionAlone(rates), kGravity);
    dynamics_->SetDriven(&still_, 0.0, c.seconds);
    solver_ = std::make_unique<ExactSolver>(dynamics_.get(), c.lower, c.upper);
    name_ = c.name;
  }

 private:
  ModelRequest request_;
  RegionModel model_;
  DrivenMotion still_;
  std::string name_;
  std::unique_ptr<RegionDynamics> dynamics_;
  std::unique_ptr<ExactSolver> solver_;
};

SwingMethod ExactMethod(const Figure& arm) {
  const auto swing = std::make_shared<ExactSwing>(arm);
  return {"hazumi_exact",
          "rad a step",
          {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13},
          [](const SwingCase&) { return true; },
          [swing](const SwingCase& c, double tolerance) { return swing->Run(c, tolerance); },
          [&arm](const SwingCase& c) {
            ExactSwing anew(arm);
            anew.Prepare(c);
            KeepAlive(anew);
          }};
}

}  // namespace

std::vector<SwingMethod> HazumiMethods(const Figure& arm) {
  return {ExactMethod(arm), PaperMethod(arm)};
}

}  // namespace hazumi::bench
