#pragma once

#include <vector>

#include "engine/passive/contact/cone_problem.h"
#include "engine/passive/region_dynamics.h"

namespace hazumi {

// The problem of one time step [METHOD 12.4]: velocities w = A l + b of what is near, for impulses
// l. A row for each that RegionDynamics lists, then one for each hinge near a limit.
class StepProblem {
 public:
  virtual ~StepProblem() = default;

  // The rows for angles q and rates qd of the free hinges, at t; and, for the same q, what impulses
  // do, which comes after it.
  virtual void Assemble(double t, const VecX& q, const VecX& qd) = 0;
  virtual void Factor() = 0;
  // After both: velocities of the rows, but limits'; and their accelerations while nothing that has
  // a row acts, with those of the free hinges, without friction's, in x_0.
  virtual VecX Rates() const = 0;
  virtual VecX Accelerations(VecX* x_0) const = 0;
  // Of rates qd of the free hinges, as far as these move bodies [J].
  virtual double KineticEnergy(const VecX& qd) const = 0;

  // Rows that are kept closed act by impulses, those with a gap to close by forces alone.
  enum class Acting { kImpulses, kForces };
  // b: `rows`, then for hinges that may reach a limit (`side`, as LimitSolver has it) what
  // `hinges`, by free hinge, says.
  virtual void SetUp(Acting acting, const std::vector<int>& side, const VecX& rows,
                     const VecX& hinges) = 0;
  virtual VecX& b() = 0;
  virtual const std::vector<ConeProblem::Block>& blocks() const = 0;
  // A's diagonal; more of it is compliance.
  virtual double Response(int row) const = 0;
  virtual void SetResponse(int row, double response) = 0;
  // Finds forces() from `start`; better ones where that `is_worth_it`.
  virtual void Sweep(VecX start, bool is_worth_it) = 0;
  virtual const VecX& forces() const = 0;
  // With them: w; and by how much the rates of the free hinges change.
  virtual VecX Velocities() const = 0;
  virtual VecX Jump() const = 0;

  // Hinges that have a row, after the others.
  const std::vector<int>& limits() const { return limits_; }
  Eigen::Index num_rows() const { return num_rows_; }
  Eigen::Index RowOfLimit(size_t k) const { return num_rows_ + static_cast<Eigen::Index>(k); }
  // What the limits' impulses do to hinges whose rates they change from `before` to `after` [J].
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
  // In SetUp.
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
