#include <memory>

#include "engine/region/exact/exact_solver.h"
#include "engine/region/forces/force_spec.h"
#include "tests/bench/springs.h"
#include "tests/bench/stopwatch.h"

namespace hazumi::bench {

namespace {

// A region of all joints, each with its spring.
class SpringRegion {
 public:
  explicit SpringRegion(const SpringArm& arm) : arm_(arm) {
    const int n = arm.figure.num_joints();
    constexpr double kFar = 1e6;  // [rad]
    ModelRequest request;
    request.roles.assign(n, Role::kFree);
    request.roles.resize(n + kRootAngles, Role::kConstant);
    request.angles = VecX::Zero(n + kRootAngles);
    still_.angles.resize(n + kRootAngles);
    SpringSpec springs;
    for (const HingeSpring& own : arm.springs) {
      Spring spring;
      spring.rate = own.rate;
      spring.damping_ratio = own.damping_ratio;
      spring.inertia = own.inertia;
      springs.springs.push_back(spring);
      still_.drives.push_back(DrivenCurve::Constant(own.angle));
    }
    dynamics_ = std::make_unique<RegionDynamics>(CompileRegionModels(arm.figure, request).front(),
                                                 MakeLaws({springs}), kGravity);
    dynamics_->SetDriven(&still_, 0.0, 1.0);
    solver_ = std::make_unique<ExactSolver>(dynamics_.get(), VecX::Constant(n, -kFar),
                                            VecX::Constant(n, kFar));
    solver_->SetLongestStep(2.0 / dynamics_->FastestRate());  // as a bake does
  }

  SpringRun Run(double seconds, double tolerance) {
    const long before = dynamics_->evaluations();
    solver_->SetTolerance(tolerance);
    solver_->Start(0.0, {arm_.q, arm_.qd});
    bool good = true;
    while (good && solver_->time() < seconds) good = !solver_->Advance(seconds);
    return {solver_->now().q, solver_->now().qd, dynamics_->evaluations() - before, good};
  }

  void Accelerate(const Question& at, VecX* qdd) {
    VecX state(dynamics_->state_size()), derivative(state.size());
    dynamics_->layout().Pack(at.q, at.qd, state.data());
    dynamics_->Derivative(0.0, state.data(), derivative.data());
    *qdd = derivative.tail(at.q.size());
  }

 private:
  const SpringArm& arm_;
  DrivenMotion still_;
  std::unique_ptr<RegionDynamics> dynamics_;
  std::unique_ptr<ExactSolver> solver_;
};

}  // namespace

SpringProgram HazumiSprings(const SpringArm& arm) {
  const auto region = std::make_shared<SpringRegion>(arm);
  SpringProgram program{"hazumi", std::make_unique<SpringSubject<SpringRegion>>(region), {}};
  program.methods.push_back(
      {"hazumi_exact",
       "rad a step",
       false,
       {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13},
       1.0,
       1e-12,
       [region](double seconds, double tolerance) { return region->Run(seconds, tolerance); },
       [&arm] { KeepAlive(SpringRegion(arm)); }});
  return program;
}

}  // namespace hazumi::bench
