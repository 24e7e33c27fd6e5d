#include "engine/dynamics/figure_dynamics.h"
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

// Inverse dynamics of all joints at once, as torques are reported.
class HazumiInverse : public Subject {
 public:
  HazumiInverse(const Figure& figure, Instructions instructions)
      : dynamics_(figure, instructions),
        scratch_(dynamics_.MakeScratch()),
        zero_(VecX::Zero(figure.num_joints())) {}

  bool InverseDynamics(const Question& at, VecX* tau) override {
    dynamics_.InverseDynamics(Pose(), root_, at.q, at.qd, at.qdd, nullptr, &scratch_, tau);
    return true;
  }
  bool Bias(const Question& at, VecX* b) override {
    dynamics_.InverseDynamics(Pose(), root_, at.q, at.qd, zero_, nullptr, &scratch_, b);
    return true;
  }

 private:
  FigureDynamics dynamics_;
  FigureScratch scratch_;
  const RootMotion root_ = RestingRoot();
  const VecX zero_;
};

// And forward dynamics as a region of all joints has it.
class Hazumi : public HazumiInverse {
 public:
  explicit Hazumi(const Figure& figure)
      : HazumiInverse(figure, BestInstructions()), free_(figure, Vec3(0.0, 0.0, kGravity)) {}

  bool ForwardDynamics(const Question& at, VecX* qdd) override {
    free_.Accelerate(at.q, at.qd, at.tau, qdd);
    return true;
  }

 private:
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

std::unique_ptr<Subject> MakeHazumiBaseline(const Figure& figure) {
  return std::make_unique<HazumiInverse>(figure, Instructions::kBaseline);
}

std::unique_ptr<Subject> MakeHazumiPaperWay(const Figure& figure) {
  return std::make_unique<HazumiPaperWay>(figure);
}

}  // namespace hazumi::bench
