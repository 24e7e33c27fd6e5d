// From which size on articulated bodies beat a dense matrix for a group of a region.

#include <cstdio>
#include <memory>

#include "engine/matrix/semidefinite.h"
#include "engine/region/region_dynamics.h"
#include "tests/bench/growing_figures.h"
#include "tests/bench/stopwatch.h"
#include "tests/bench/tables.h"

namespace hazumi::bench {

namespace {

// A chain whose hinges are all free, on a root that stands still.
class FreeChain {
 public:
  explicit FreeChain(int joints) : joints_(joints), model_(ModelOf(Chain(joints))) {
    driven_.angles.resize(joints + kRootAngles);
    dynamics_ = std::make_unique<RegionDynamics>(model_, ForceLaws(), 9.81);
    dynamics_->SetDriven(&driven_, 0.0, 1.0);
    q_ = VecX::LinSpaced(joints, 0.1, 1.0);
    qd_ = VecX::LinSpaced(joints, -1.0, 1.0);
    state_.resize(dynamics_->layout().state_size());
    derivative_.resize(state_.size());
    L_.resize(joints, joints);
    dynamics_->layout().Pack(q_, qd_, state_.data());
  }

  void Round() {
    constexpr double kBatchSeconds = 0.002;
    articulated_.Round(kBatchSeconds, [this](long) {
      dynamics_->Derivative(0.0, state_.data(), derivative_.data());
    });
    dense_.Round(kBatchSeconds, [this](long) {
      const HingeEquations equations = dynamics_->AssembleHinges(0.0, {q_, qd_});
      L_ = equations.M();
      FactorSemidefinite(L_);
      x_ = -equations.b();
      SolveSemidefinite(L_, x_);
    });
  }

  void Print() const {
    std::printf("region_articulated,region,%d,%.4g\n", joints_, articulated_.microseconds());
    std::printf("region_dense,region,%d,%.4g\n", joints_, dense_.microseconds());
  }

 private:
  static RegionModel ModelOf(const Figure& figure) {
    ModelRequest request;
    request.roles.assign(figure.num_joints() + kRootAngles, Role::kConstant);
    std::fill_n(request.roles.begin(), figure.num_joints(), Role::kFree);
    request.angles = VecX::Zero(figure.num_joints() + kRootAngles);
    return CompileRegionModels(figure, request).at(0);
  }

  int joints_;
  RegionModel model_;
  DrivenMotion driven_;
  std::unique_ptr<RegionDynamics> dynamics_;
  VecX q_, qd_, state_, derivative_, x_;
  MatX L_;
  LeastTime articulated_, dense_;
};

}  // namespace

void PrintRegionScaling(int rounds) {
  std::vector<std::unique_ptr<FreeChain>> all;
  for (const int joints : {1, 2, 3, 5, 7, 10, 14, 20, 30, 50, 100}) {
    all.push_back(std::make_unique<FreeChain>(joints));
  }
  for (int round = 0; round < rounds; ++round) {
    for (const auto& chain : all) chain->Round();
  }
  for (const auto& chain : all) chain->Print();
}

}  // namespace hazumi::bench
