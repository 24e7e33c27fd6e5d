#pragma once

#include <vector>

#include "engine/region/contact/cone_problem.h"
#include "engine/region/region_dynamics.h"

namespace hazumi {

// Problem of one time step [METHOD 12.4]: velocities w = A l + b of the nearby rows for impulses l.
// One row for each row of RowSystem, then one for each hinge near a limit.
class StepProblem {
 public:
  virtual ~StepProblem() = default;

  // Assembles the rows for a state at t; Factor then prepares their response to impulses for the
  // same angles.
  virtual void Assemble(double t, const HingeState& state) = 0;
  virtual void Factor() = 0;
  // Velocities of the rows except those of limits. Accelerations without the forces of the rows and
  // without friction; x_0: those of the free hinges. Require Assemble and Factor.
  virtual VecX Rates() const = 0;
  virtual VecX Accelerations(VecX* x_0) const = 0;
  // Kinetic energy for rates qd of the free hinges, as far as these move bodies [J].
  virtual double KineticEnergy(const VecX& qd) const = 0;

  // Selects how rows act: active rows by impulses, rows with a gap by forces alone.
  enum class Acting { kImpulses, kForces };
  // Sets b: `rows`, then the entries of `hinges` (by free hinge) for hinges that may reach a limit
  // (`side`, as in LimitSolver).
  virtual void SetUp(Acting acting, const std::vector<int>& side, const VecX& rows,
                     const VecX& hinges) = 0;
  virtual VecX& b() = 0;
  virtual const std::vector<ConeProblem::Block>& blocks() const = 0;
  // Diagonal of A. An increase is compliance.
  virtual double Response(int row) const = 0;
  virtual void SetResponse(int row, double response) = 0;
  // Solves for forces() from `start`. More accurate where that `is_worth_it`.
  virtual void Sweep(VecX start, bool is_worth_it) = 0;
  virtual const VecX& forces() const = 0;
  // Velocities w with these forces; change of the rates of the free hinges.
  virtual VecX Velocities() const = 0;
  virtual VecX Jump() const = 0;

  // Hinges with a row, which follow the other rows.
  const std::vector<int>& limits() const { return limits_; }
  Eigen::Index num_rows() const { return num_rows_; }
  Eigen::Index RowOfLimit(size_t k) const { return num_rows_ + static_cast<Eigen::Index>(k); }
  // Work of the impulses of limits on hinges whose rates change from `before` to `after` [J].
  double WorkOfLimits(const std::vector<int>& side, const VecX& before, const VecX& after) const {
    double work = 0.0;
    for (size_t k = 0; k < limits_.size(); ++k) {
      const int hinge = limits_[k];
      work -= side[hinge] * forces()[RowOfLimit(k)] * 0.5 * (before[hinge] + after[hinge]);
    }
    return work;
  }
  VecX row_forces() const { return forces().head(num_rows_); }

 protected:
  // Lists the hinges near limits. Called by SetUp.
  void ListLimits(const std::vector<int>& side, Eigen::Index num_rows) {
    num_rows_ = num_rows;
    limits_.clear();
    for (int i = 0; i < static_cast<int>(side.size()); ++i) {
      if (side[i] != 0) limits_.push_back(i);
    }
  }

 private:
  std::vector<int> limits_;
  Eigen::Index num_rows_ = 0;
};

}  // namespace hazumi
