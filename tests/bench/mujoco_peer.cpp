// The figure in MuJoCo: hinges of one group share a body (test::MujocoFigure), or a ball joint.

#include <mujoco/mujoco.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "tests/bench/mujoco_ball_model.h"
#include "tests/bench/peer_joints.h"
#include "tests/bench/step_method.h"
#include "tests/bench/stopwatch.h"
#include "tests/bench/subject.h"
#include "tests/bench/swing_method.h"
#include "tests/support/mujoco_figure.h"

namespace hazumi::bench {

namespace {

class Mujoco : public Subject {
 public:
  explicit Mujoco(const Figure& figure)
      : figure_(figure, Pose(), Vec3(0.0, 0.0, -kGravity)),
        model_(figure_.model()),
        data_(figure_.data()) {}

  bool InverseDynamics(const Question& at, VecX* tau) override {
    PlaceAndMove(at);
    mju_copy(data_->qacc, at.qdd.data(), model_->nv);
    mj_rne(model_, data_, 1, tau->data());
    return true;
  }
  bool Bias(const Question& at, VecX* b) override {
    PlaceAndMove(at);
    mj_rne(model_, data_, 0, b->data());
    return true;
  }
  bool InertiaMatrix(const Question& at, MatX* H) override {
    Place(at);
    mj_crb(model_, data_);
    if (H != nullptr) mj_fullM(model_, H->data(), data_->qM);
    return true;
  }
  bool ForwardDynamics(const Question& at, VecX* qdd) override {
    mju_copy(data_->qpos, at.q.data(), model_->nv);
    mju_copy(data_->qvel, at.qd.data(), model_->nv);
    mju_copy(data_->qfrc_applied, at.tau.data(), model_->nv);
    mj_forward(model_, data_);
    mju_copy(qdd->data(), data_->qacc, model_->nv);
    return true;
  }

 private:
  void Place(const Question& at) {
    mju_copy(data_->qpos, at.q.data(), model_->nv);
    mj_kinematics(model_, data_);
    mj_comPos(model_, data_);
  }
  void PlaceAndMove(const Question& at) {
    Place(at);
    mju_copy(data_->qvel, at.qd.data(), model_->nv);
    mj_comVel(model_, data_);
  }

  test::MujocoFigure figure_;
  const mjModel* model_;
  mjData* data_;
};

// A model whose options may be changed, and where its ball joints are.
class MujocoArm {
 public:
  MujocoArm(std::shared_ptr<mjModel> model, std::vector<BallJoint> balls)
      : model_(std::move(model)),
        data_(mj_makeData(model_.get()), mj_deleteData),
        balls_(std::move(balls)) {}

  const std::vector<BallJoint>& balls() const { return balls_; }
  mjModel* model() { return model_.get(); }
  mjData* data() { return data_.get(); }

  void SetState(const VecX& q, const VecX& qd);
  VecX Angles() const;

 private:
  // MuJoCo's coordinates of joint j: a ball has four in the place of three.
  int CoordinateOf(int joint) const;

  std::shared_ptr<mjModel> model_;
  std::shared_ptr<mjData> data_;
  std::vector<BallJoint> balls_;
};

int MujocoArm::CoordinateOf(int joint) const {
  int coordinate = joint;
  for (const BallJoint& ball : balls_) coordinate += ball.first() < joint ? 1 : 0;
  return coordinate;
}

void MujocoArm::SetState(const VecX& q, const VecX& qd) {
  mj_resetData(model_.get(), data_.get());
  for (int j = 0; j < q.size(); ++j) data_->qpos[CoordinateOf(j)] = q[j];
  mju_copy(data_->qvel, qd.data(), model_->nv);
  for (const BallJoint& ball : balls_) {
    const Mat3 R = ball.Rotation(q);
    const Eigen::Quaterniond turn(R);
    const Vec3 w = R.transpose() * ball.AngularVelocity(q, qd);  // in the axes of the body
    const double wxyz[] = {turn.w(), turn.x(), turn.y(), turn.z()};
    mju_copy(data_->qpos + CoordinateOf(ball.first()), wxyz, 4);
    mju_copy(data_->qvel + ball.first(), w.data(), 3);
  }
}

VecX MujocoArm::Angles() const {
  VecX q(model_->nv);
  for (int j = 0; j < q.size(); ++j) q[j] = data_->qpos[CoordinateOf(j)];
  for (const BallJoint& ball : balls_) {
    const double* wxyz = data_->qpos + CoordinateOf(ball.first());
    ball.SetHingeAngles(Eigen::Quaterniond(wxyz[0], wxyz[1], wxyz[2], wxyz[3]).toRotationMatrix(),
                        &q);
  }
  return q;
}

class MujocoWithBalls : public Subject {
 public:
  explicit MujocoWithBalls(const Figure& figure)
      : arm_(LoadMujocoModelWithBalls(figure), BallJoints(figure)) {}

  bool ForwardDynamics(const Question& at, VecX* qdd) override {
    arm_.SetState(at.q, at.qd);
    mju_copy(arm_.data()->qfrc_applied, at.tau.data(), arm_.model()->nv);
    for (const BallJoint& ball : arm_.balls()) {
      const Vec3 moment = ball.Rotation(at.q).transpose() * ball.Moment(at.q, at.tau);
      mju_copy(arm_.data()->qfrc_applied + ball.first(), moment.data(), 3);
    }
    mj_forward(arm_.model(), arm_.data());
    mju_copy(qdd->data(), arm_.data()->qacc, arm_.model()->nv);
    for (const BallJoint& ball : arm_.balls()) {
      const Vec3 alpha = qdd->segment<3>(ball.first());
      ball.SetHingeAccelerations(at.q, at.qd, ball.Rotation(at.q) * alpha, qdd);
    }
    return true;
  }

 private:
  MujocoArm arm_;
};

VecX Swing(MujocoArm* arm, const SwingCase& c, double steps) {
  arm->SetState(c.q, c.qd);
  arm->model()->opt.timestep = c.seconds / steps;
  for (int i = 0; i < steps; ++i) mj_step(arm->model(), arm->data());
  return arm->Angles();
}

using ArmMaker = std::function<std::shared_ptr<MujocoArm>()>;

SwingMethod Method(const char* name, mjtIntegrator integrator, std::vector<double> settings,
                   const ArmMaker& make) {
  const std::shared_ptr<MujocoArm> arm = make();
  return {name,
          "steps",
          std::move(settings),
          arm->balls().empty() ? FreeWithHinges : FreeNearSingularity,
          [arm, integrator](const SwingCase& c, double steps) {
            arm->model()->opt.integrator = integrator;
            return Swing(arm.get(), c, steps);
          },
          [make](const SwingCase&) { KeepAlive(make()); }};
}

// MuJoCo starts anew, with a warning, from a state that is not finite or beyond 1e10.
bool HasGivenUp(const mjData* data) {
  const mjWarningStat* warning = data->warning;
  return warning[mjWARN_BADQPOS].number + warning[mjWARN_BADQVEL].number +
             warning[mjWARN_BADQACC].number >
         0;
}

double EnergyAfterASecond(MujocoArm* arm, const VecX& q, const VecX& qd, int steps) {
  arm->SetState(q, qd);
  arm->model()->opt.timestep = 1.0 / steps;
  for (int i = 0; i < steps && !HasGivenUp(arm->data()); ++i) mj_step(arm->model(), arm->data());
  if (HasGivenUp(arm->data())) return std::numeric_limits<double>::quiet_NaN();
  arm->model()->opt.enableflags |= mjENBL_ENERGY;
  mj_forward(arm->model(), arm->data());
  arm->model()->opt.enableflags &= ~mjENBL_ENERGY;
  return arm->data()->energy[0] + arm->data()->energy[1];
}

StepMethod InSteps(const char* name, mjtIntegrator integrator,
                   const std::shared_ptr<MujocoArm>& arm) {
  return {name, integrator == mjINT_RK4 ? 4 : 1,
          [arm, integrator](const VecX& q, const VecX& qd, int steps) {
            arm->model()->opt.integrator = integrator;
            return EnergyAfterASecond(arm.get(), q, qd, steps);
          }};
}

}  // namespace

std::unique_ptr<Subject> MakeMujoco(const Figure& figure) {
  return std::make_unique<Mujoco>(figure);
}

std::unique_ptr<Subject> MakeMujocoWithBalls(const Figure& figure) {
  return std::make_unique<MujocoWithBalls>(figure);
}

namespace {

std::shared_ptr<MujocoArm> ArmOfHinges(const Figure& arm) {
  const test::MujocoFigure figure(arm, Pose(), Vec3(0.0, 0.0, -kGravity));
  return std::make_shared<MujocoArm>(
      std::shared_ptr<mjModel>(mj_copyModel(nullptr, figure.model()), mj_deleteModel),
      std::vector<BallJoint>());
}

std::shared_ptr<MujocoArm> ArmOfBalls(const Figure& arm) {
  return std::make_shared<MujocoArm>(LoadMujocoModelWithBalls(arm), BallJoints(arm));
}

}  // namespace

std::vector<StepMethod> MujocoStepMethods(const Figure& arm) {
  mju_user_warning = [](const char*) {};  // no log file of the swings that are lost
  const auto hinges = ArmOfHinges(arm), ball = ArmOfBalls(arm);
  return {InSteps("mujoco_euler", mjINT_EULER, hinges), InSteps("mujoco_rk4", mjINT_RK4, hinges),
          InSteps("mujoco_euler_ball", mjINT_EULER, ball),
          InSteps("mujoco_rk4_ball", mjINT_RK4, ball)};
}

std::vector<SwingMethod> MujocoMethods(const Figure& arm) {
  const ArmMaker hinges = [&arm] { return ArmOfHinges(arm); };
  const ArmMaker ball = [&arm] { return ArmOfBalls(arm); };
  const std::vector<double> euler = GeometricSettings(16, 4, 7);
  const std::vector<double> rk4 = GeometricSettings(8, 2, 11);
  return {Method("mujoco_euler", mjINT_EULER, euler, hinges),
          Method("mujoco_rk4", mjINT_RK4, rk4, hinges),
          Method("mujoco_euler_ball", mjINT_EULER, euler, ball),
          Method("mujoco_rk4_ball", mjINT_RK4, rk4, ball)};
}

}  // namespace hazumi::bench
