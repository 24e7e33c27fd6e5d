#pragma once

#include <optional>
#include <utility>

#include "engine/region/exact/contact_problem.h"
#include "engine/region/exact/step_problem.h"

namespace hazumi {

// Solves the step with a dense A, by ContactProblem. The time of a step grows with the cube of rows
// and hinges.
class DenseStepProblem : public StepProblem {
 public:
  // Requires that `dynamics` outlives this object.
  explicit DenseStepProblem(RegionDynamics* dynamics)
      : dynamics_(dynamics), problem_(dynamics), none_(dynamics->hinges().size(), 0) {}

  void Assemble(double t, const HingeState& state) override {
    equations_ = dynamics_->AssembleHinges(t, state);
    b_ = equations_->b();
  }
  void Factor() override { problem_.Factor(equations_->M()); }
  const HingeEquations& equations() const { return *equations_; }
  // Factors other equations instead of the assembled ones, until the next Assemble and Factor.
  void FactorInstead(const MatX& M, const VecX& b) {
    problem_.Factor(M);
    b_ = b;
  }
  VecX Rates() const override {
    const LimitRows* rows = equations_->for_impulses();
    return rows ? rows->c : VecX();
  }
  VecX Accelerations(VecX* x_0) const override { return problem_.Unheld(*equations_, b_, x_0).c; }
  double KineticEnergy(const VecX& qd) const override { return 0.5 * qd.dot(equations_->M() * qd); }
  void SetUp(Acting acting, const std::vector<int>& side, const VecX& rows,
             const VecX& hinges) override {
    const LimitRows* known =
        acting == Acting::kImpulses ? equations_->for_impulses() : equations_->for_forces();
    LimitRows own;
    own.J.resize(0, hinges.size());
    if (known) own = *known;
    own.c = rows;
    ListLimits(side, rows.size());
    problem_.SetUp(side, none_, own, hinges);
  }
  VecX& b() override { return problem_.cones().b; }
  const std::vector<ConeProblem::Block>& blocks() const override { return problem_.cones().blocks; }
  double Response(int row) const override { return problem_.cones().A(row, row); }
  void SetResponse(int row, double response) override { problem_.cones().A(row, row) = response; }
  void Sweep(VecX start, bool is_worth_it) override {
    problem_.Sweep(std::move(start), is_worth_it);
  }
  const VecX& forces() const override { return problem_.forces(); }
  VecX Velocities() const override {
    return problem_.cones().A * problem_.forces() + problem_.cones().b;
  }
  VecX Jump() const override { return problem_.Answer(); }

 private:
  RegionDynamics* dynamics_;
  std::optional<HingeEquations> equations_;
  ContactProblem problem_;
  std::vector<char> none_;  // one per hinge
  VecX b_;                  // right-hand side of M x = -b
};

}  // namespace hazumi
