#include "engine/dynamics/inverse_dynamics.h"
#include "engine/dynamics/kinematics.h"
#include "tests/bench/subject.h"
#include "tests/support/dense_dynamics.h"
#include "tests/support/free_figure.h"

namespace hazumi::bench {

namespace {

// A root at rest in the field of gravity.
RootMotion RestingRoot() {
  RootMotion root;
  root.a = Vec3(0.0, 0.0, kGravity);
  return root;
}

class Hazumi : public Subject {
 public:
  explicit Hazumi(const Figure& figure)
      : figure_(figure),
        ws_(figure),
        zero_(VecX::Zero(figure.num_joints())),
        free_(figure, Vec3(0.0, 0.0, kGravity)) {}

  bool InverseDynamics(const Question& at, VecX* tau) override {
    return Recursion(at, at.qdd, tau);
  }
  bool Bias(const Question& at, VecX* b) override { return Recursion(at, zero_, b); }
  bool ForwardDynamics(const Question& at, VecX* qdd) override {
    free_.Accelerate(at.q, at.qd, at.tau, qdd);
    return true;
  }

 private:
  bool Recursion(const Question& at, const VecX& qdd, VecX* tau) {
    ComputePositions(figure_, Pose(), at.q, &ws_);
    hazumi::InverseDynamics(figure_, root_, at.qd, qdd, nullptr, &ws_);
    *tau = ws_.tau;
    return true;
  }

  const Figure& figure_;
  DynamicsWorkspace ws_;
  const RootMotion root_ = RestingRoot();
  const VecX zero_;
  test::FreeFigure free_;
};

class HazumiPaperWay : public Subject {
 public:
  explicit HazumiPaperWay(const Figure& figure) : figure_(figure), ws_(figure) {}

  bool InertiaMatrix(const Question& at, MatX* H) override {
    ComputePositions(figure_, Pose(), at.q, &ws_);
    test::InertiaMatrix(figure_, &ws_, H != nullptr ? H : &H_);
    return true;
  }
  bool ForwardDynamics(const Question& at, VecX* qdd) override {
    ComputePositions(figure_, Pose(), at.q, &ws_);
    return !test::ForwardDynamics(figure_, root_, at.qd, at.tau, nullptr, &ws_, qdd);
  }

 private:
  const Figure& figure_;
  DynamicsWorkspace ws_;
  const RootMotion root_ = RestingRoot();
  MatX H_;
};

}  // namespace

std::unique_ptr<Subject> MakeHazumi(const Figure& figure) {
  return std::make_unique<Hazumi>(figure);
}

std::unique_ptr<Subject> MakeHazumiPaperWay(const Figure& figure) {
  return std::make_unique<HazumiPaperWay>(figure);
}

}  // namespace hazumi::bench
