#include "engine/dynamics/figure_dynamics.h"
#include "engine/dynamics/forward_dynamics.h"
#include "engine/dynamics/inertia_matrix.h"
#include "engine/dynamics/inverse_dynamics.h"
#include "engine/dynamics/mixed_dynamics.h"
#include "tests/bench/subject.h"

namespace hazumi::bench {

namespace {

// What our subjects share: positions, and a root at rest in the field of gravity.
class HazumiBase : public Subject {
 public:
  explicit HazumiBase(const Figure& figure)
      : figure_(figure), ws_(figure), zero_(VecX::Zero(figure.num_joints())) {
    root_.a = Vec3(0.0, 0.0, kGravity);
  }

 protected:
  void Place(const Question& at) { ComputePositions(figure_, Pose(), at.q, &ws_); }
  MatX* Storage(MatX* H) {
    if (H != nullptr) return H;
    H_.resize(zero_.size(), zero_.size());
    return &H_;
  }

  const Figure& figure_;
  DynamicsWorkspace ws_;
  RootMotion root_;
  VecX zero_;
  MatX H_;
};

class Hazumi : public HazumiBase {
 public:
  Hazumi(const Figure& figure, Instructions instructions)
      : HazumiBase(figure), dynamics_(figure, instructions), scratch_(dynamics_.MakeScratch()) {}

  bool InverseDynamics(const Question& at, VecX* tau) override {
    dynamics_.InverseDynamics(Pose(), root_, at.q, at.qd, at.qdd, nullptr, &scratch_, tau);
    return true;
  }
  bool Bias(const Question& at, VecX* b) override {
    dynamics_.InverseDynamics(Pose(), root_, at.q, at.qd, zero_, nullptr, &scratch_, b);
    return true;
  }
  bool InertiaMatrix(const Question& at, MatX* H) override {
    Place(at);
    InertiaMatrixByCompositeBodies(figure_, &ws_, Storage(H));
    return true;
  }
  bool ForwardDynamics(const Question& at, VecX* qdd) override {
    return !dynamics_.ForwardDynamics(Pose(), root_, at.q, at.qd, at.tau, nullptr, &scratch_, qdd);
  }

 private:
  FigureDynamics dynamics_;
  FigureScratch scratch_;
};

class HazumiPaperWay : public HazumiBase {
 public:
  using HazumiBase::HazumiBase;

  bool InertiaMatrix(const Question& at, MatX* H) override {
    Place(at);
    InertiaMatrixByUnitAccelerations(figure_, &ws_, Storage(H));
    return true;
  }
  bool ForwardDynamics(const Question& at, VecX* qdd) override {
    Place(at);
    return !ForwardDynamicsDense(figure_, root_, at.qd, at.tau, nullptr, &ws_, qdd);
  }
};

class HazumiComposite : public HazumiBase {
 public:
  using HazumiBase::HazumiBase;

  bool ForwardDynamics(const Question& at, VecX* qdd) override {
    Place(at);
    hazumi::InverseDynamics(figure_, root_, at.qd, zero_, nullptr, &ws_);
    *qdd = at.tau - ws_.tau;
    InertiaMatrixByCompositeBodies(figure_, &ws_, Storage(nullptr));
    if (FactorCholesky(H_) >= 0) return false;
    SolveCholesky(H_, *qdd);
    return true;
  }
};

}  // namespace

std::unique_ptr<Subject> MakeHazumi(const Figure& figure) {
  return std::make_unique<Hazumi>(figure, BestInstructions());
}

std::unique_ptr<Subject> MakeHazumiBaseline(const Figure& figure) {
  return std::make_unique<Hazumi>(figure, Instructions::kBaseline);
}

std::unique_ptr<Subject> MakeHazumiPaperWay(const Figure& figure) {
  return std::make_unique<HazumiPaperWay>(figure);
}

std::unique_ptr<Subject> MakeHazumiComposite(const Figure& figure) {
  return std::make_unique<HazumiComposite>(figure);
}

}  // namespace hazumi::bench
