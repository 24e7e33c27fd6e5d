#include <cmath>

#include "tests/bench/falls.h"
#include "tests/bench/mujoco_fall_model.h"
#include "tests/bench/subject.h"

namespace hazumi::bench {

namespace {

class MujocoFall {
 public:
  explicit MujocoFall(const Animation& fall)
      : start_(StartOfFall(fall)),
        model_(LoadMujocoFall(*fall.figure)),
        data_(mj_makeData(model_.get()), mj_deleteData) {
    DampLike(fall.regions[0].friction);
  }

  // `look`: called after each step; null: not.
  template <typename Look>
  bool Fall(mjtIntegrator integrator, double seconds, double step, const Look& look) {
    const int steps = static_cast<int>(std::ceil(seconds / step - 1e-9));
    model_->opt.integrator = integrator;
    model_->opt.timestep = seconds / steps;
    Place();
    for (int i = 0; i < steps; ++i) {
      mj_step(model_.get(), data_.get());
      if (HasGivenUp()) return false;
      look();
    }
    return true;
  }

  // Frames ascending, a whole number of steps each.
  std::vector<MotionLimit> States(mjtIntegrator integrator, double step,
                                  const std::vector<int>& frames);
  FallAccount Account(mjtIntegrator integrator, double step);

 private:
  void DampLike(const std::vector<double>& friction);
  void Place();
  MotionLimit State() const;
  double Energy();  // of the state now, without a step [J]
  bool HasGivenUp() const {
    const mjWarningStat* warning = data_->warning;
    return warning[mjWARN_BADQPOS].number + warning[mjWARN_BADQVEL].number +
               warning[mjWARN_BADQACC].number >
           0;
  }

  MotionLimit start_;
  std::shared_ptr<mjModel> model_;
  std::shared_ptr<mjData> data_;
};

// There is no such friction in MuJoCo: torques that slow a joint down as the friction factor does
// where nothing else moves or touches, in the pose at the start (dof_invweight0 is 1 / M there).
void MujocoFall::DampLike(const std::vector<double>& friction) {
  for (size_t j = 0; j < friction.size(); ++j) {
    const double rate = -30.0 * std::log(friction[j]);  // [1/s]
    model_->dof_damping[6 + j] = rate == 0.0 ? 0.0 : rate / model_->dof_invweight0[6 + j];
  }
}

// A free joint's velocity is the origin's in the world and the turn about its own axes.
void MujocoFall::Place() {
  mj_resetData(model_.get(), data_.get());
  const Eigen::Quaterniond turn(start_.X_WR.R);
  const double wxyz[] = {turn.w(), turn.x(), turn.y(), turn.z()};
  const Vec3 w = start_.X_WR.R.transpose() * start_.root_w;
  const int n = static_cast<int>(start_.q.size());
  mju_copy(data_->qpos, start_.X_WR.p.data(), 3);
  mju_copy(data_->qpos + 3, wxyz, 4);
  mju_copy(data_->qpos + 7, start_.q.data(), n);
  mju_copy(data_->qvel, start_.root_v.data(), 3);
  mju_copy(data_->qvel + 3, w.data(), 3);
  mju_copy(data_->qvel + 6, start_.qd.data(), n);
}

MotionLimit MujocoFall::State() const {
  MotionLimit at;
  const double* wxyz = data_->qpos + 3;
  at.X_WR.R =
      Eigen::Quaterniond(wxyz[0], wxyz[1], wxyz[2], wxyz[3]).normalized().toRotationMatrix();
  at.X_WR.p = Eigen::Map<const Vec3>(data_->qpos);
  at.root_v = Eigen::Map<const Vec3>(data_->qvel);
  at.root_w = at.X_WR.R * Eigen::Map<const Vec3>(data_->qvel + 3);
  at.q = Eigen::Map<const VecX>(data_->qpos + 7, model_->nv - 6);
  at.qd = Eigen::Map<const VecX>(data_->qvel + 6, model_->nv - 6);
  return at;
}

std::vector<MotionLimit> MujocoFall::States(mjtIntegrator integrator, double step,
                                            const std::vector<int>& frames) {
  std::vector<MotionLimit> states;
  const double last = frames.back() / 30.0;
  const double h = last / std::ceil(last / step - 1e-9);
  long taken = 0;
  Fall(integrator, last, step, [&] {
    ++taken;
    const double next = frames[states.size()] / 30.0;
    if (std::abs(static_cast<double>(taken) * h - next) < 0.5 * h) states.push_back(State());
  });
  return states;
}

double MujocoFall::Energy() {
  model_->opt.enableflags |= mjENBL_ENERGY;
  mj_forward(model_.get(), data_.get());
  model_->opt.enableflags &= ~mjENBL_ENERGY;
  return data_->energy[0] + data_->energy[1];
}

// The work of the forces of contacts and limits of each step, h f . (v + v_after) / 2, is just what
// its semi-implicit step makes of them; of its other integrators there is no such account.
FallAccount MujocoFall::Account(mjtIntegrator integrator, double step) {
  FallAccount account;
  Place();
  const double before = Energy();
  double work = 0.0;
  VecX v = Eigen::Map<const VecX>(data_->qvel, model_->nv);
  account.finished = Fall(integrator, kFallSeconds, step, [&] {
    const Eigen::Map<const VecX> after(data_->qvel, model_->nv);
    const Eigen::Map<const VecX> held(data_->qfrc_constraint, model_->nv);
    const Eigen::Map<const VecX> passive(data_->qfrc_passive, model_->nv);
    work += 0.5 * model_->opt.timestep * (held + passive).dot(v + after);
    v = after;
    for (int i = 0; i < data_->ncon; ++i) {
      account.depth = std::max(account.depth, -data_->contact[i].dist);
    }
  });
  if (!account.finished) return account;
  account.lost = before - Energy();
  if (integrator == mjINT_EULER) account.unaccounted = -account.lost - work;
  return account;
}

FallMethod Method(const char* name, mjtIntegrator integrator, const std::vector<double>& steps,
                  const std::shared_ptr<MujocoFall>& own) {
  const auto nothing = [] {};
  return {name,
          "s a step",
          steps,
          1e-6,
          4e-6,
          0.002,
          [=](double step) { return own->Fall(integrator, kFallSeconds, step, nothing); },
          [=](double step, const std::vector<int>& frames) {
            return own->States(integrator, step, frames);
          },
          [=](double step) { return own->Account(integrator, step); }};
}

}  // namespace

std::vector<FallMethod> MujocoFalls(const Animation& fall) {
  mju_user_warning = [](const char*) {};  // no log file of the falls that are lost
  const auto own = std::make_shared<MujocoFall>(fall);
  const std::vector<double> steps = {0.01, 0.005, 0.002, 0.001, 5e-4, 2e-4, 1e-4};
  return {Method("mujoco_euler", mjINT_EULER, steps, own),
          Method("mujoco_implicit", mjINT_IMPLICIT, steps, own),
          Method("mujoco_rk4", mjINT_RK4, steps, own)};
}

}  // namespace hazumi::bench
