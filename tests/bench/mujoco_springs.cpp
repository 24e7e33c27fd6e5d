#include <mujoco/mujoco.h>

#include <cmath>
#include <memory>

#include "tests/bench/springs.h"
#include "tests/bench/stopwatch.h"
#include "tests/bench/swing_method.h"
#include "tests/support/mujoco_figure.h"

namespace hazumi::bench {

namespace {

// The arm with stiffness and damping of its joints. A model whose options may be changed.
class MujocoSpringArm {
 public:
  explicit MujocoSpringArm(const SpringArm& arm) : arm_(arm) {
    const test::MujocoFigure figure(arm.figure, Pose(), Vec3(0.0, 0.0, -kGravity));
    model_.reset(mj_copyModel(nullptr, figure.model()), mj_deleteModel);
    model_->opt.disableflags &= ~mjDSBL_PASSIVE;
    for (int j = 0; j < model_->nv; ++j) {
      const HingeSpring& spring = arm.springs[j];
      model_->jnt_stiffness[j] = spring.stiffness();
      model_->dof_damping[j] = spring.damping();
      model_->qpos_spring[j] = spring.angle;
    }
    model_->nstack = 100000;  // the figure's own has too little for its implicit steps
    data_.reset(mj_makeData(model_.get()), mj_deleteData);
  }

  SpringRun Run(mjtIntegrator integrator, double seconds, double step) {
    const int steps = static_cast<int>(std::ceil(seconds / step - 1e-9));
    Place(arm_.q, arm_.qd);
    model_->opt.integrator = integrator;
    model_->opt.timestep = seconds / steps;
    for (int i = 0; i < steps; ++i) {
      mj_step(model_.get(), data_.get());
      if (HasGivenUp()) return {};
    }
    const int n = model_->nv;
    return {Eigen::Map<const VecX>(data_->qpos, n), Eigen::Map<const VecX>(data_->qvel, n),
            static_cast<long>(steps) * (integrator == mjINT_RK4 ? 4 : 1), true};
  }

  void Accelerate(const Question& at, VecX* qdd) {
    Place(at.q, at.qd);
    mj_forward(model_.get(), data_.get());
    mju_copy(qdd->data(), data_->qacc, model_->nv);
  }

 private:
  void Place(const VecX& q, const VecX& qd) {
    mj_resetData(model_.get(), data_.get());
    mju_copy(data_->qpos, q.data(), model_->nv);
    mju_copy(data_->qvel, qd.data(), model_->nv);
  }
  // It starts anew, with a warning, from a state that is not finite or beyond 1e10.
  bool HasGivenUp() const {
    const mjWarningStat* warning = data_->warning;
    return warning[mjWARN_BADQPOS].number + warning[mjWARN_BADQVEL].number +
               warning[mjWARN_BADQACC].number >
           0;
  }

  const SpringArm& arm_;
  std::shared_ptr<mjModel> model_;
  std::shared_ptr<mjData> data_;
};

}  // namespace

SpringProgram MujocoSprings(const SpringArm& arm) {
  mju_user_warning = [](const char*) {};  // no log file of the swings that are lost
  const auto own = std::make_shared<MujocoSpringArm>(arm);
  SpringProgram program{"mujoco", std::make_unique<SpringSubject<MujocoSpringArm>>(own), {}};
  const auto add = [&](const char* name, mjtIntegrator integrator, double ratio, int count) {
    program.methods.push_back({name, "s a step", true, GeometricSettings(1.0 / 48, ratio, count),
                               0.1, 1e-5,
                               [own, integrator](double seconds, double step) {
                                 return own->Run(integrator, seconds, step);
                               },
                               [&arm] { KeepAlive(MujocoSpringArm(arm)); }});
  };
  add("mujoco_euler", mjINT_EULER, 0.25, 7);
  add("mujoco_implicit", mjINT_IMPLICIT, 0.25, 7);
  add("mujoco_rk4", mjINT_RK4, 0.5, 11);
  return program;
}

}  // namespace hazumi::bench
