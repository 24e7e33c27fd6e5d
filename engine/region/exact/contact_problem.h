#pragma once

#include <vector>

#include "engine/region/contact/cone_problem.h"
#include "engine/region/region_dynamics.h"

namespace hazumi {

// Problem of the forces of contacts, constraints and limits of an island at one instant: a row for
// each that RowSystem lists, then one for each hinge that is at a limit. [METHOD 12]
class ContactProblem {
 public:
  // `dynamics` must outlive it.
  explicit ContactProblem(RegionDynamics* dynamics) : dynamics_(dynamics) {}

  // Factors M. Required by the other functions.
  void Factor(const MatX& M);
  // Returns the rows of the equations, with their accelerations without constraint forces, and x_0
  // for this b.
  LimitRows Unheld(const HingeEquations& equations, const VecX& b, VecX* x_0) const;
  // For rows that would do rows.c. A hinge at a limit, by free hinge as LimitSolver has `side` and
  // `sticks`, would do x_0.
  void SetUp(const std::vector<int>& side, const std::vector<char>& sticks, const LimitRows& rows,
             const VecX& x_0);
  // As SolveCones.
  bool Solve();
  // `known` act, and what goes in even so is stopped; forces() are all of them.
  void SolveBeside(const VecX& known);
  // Of velocities that forces() change: the energy that goes into them [J].
  double Gain() const { return forces_.dot(0.5 * (cones_.A * forces_) + cones_.b); }
  // Work of the impulses of limits on hinges whose rates change from `before` to `after` [J]. Valid
  // if the problem is one of velocities.
  double WorkOfLimits(const std::vector<int>& side, const VecX& before, const VecX& after) const;
  // For less, from forces that are as near as the caller knows; from inside of the cones where
  // that does not come near, unless that is not worth it.
  void Sweep(VecX start, bool is_worth_it);

  ConeProblem& cones() { return cones_; }
  const ConeProblem& cones() const { return cones_; }
  const MatX& factor() const { return L_; }  // M = L L^T
  // Of all rows, of those that are no limits', and what they do to the hinges.
  const VecX& forces() const { return forces_; }
  VecX row_forces() const { return forces_.head(num_rows()); }
  VecX Answer() const;
  // Hinges that have a row, after the others.
  const std::vector<int>& limits() const { return limits_; }
  Eigen::Index num_rows() const {
    return cones_.b.size() - static_cast<Eigen::Index>(limits_.size());
  }
  Eigen::Index RowOfLimit(size_t k) const { return num_rows() + static_cast<Eigen::Index>(k); }

 private:
  // Adds so many multiplications to the work of the island.
  void AddWork(double products) { dynamics_->AddWork({.contacts = products * 1e-5}); }

  RegionDynamics* dynamics_;
  ConeProblem cones_;
  MatX L_, half_answer_;  // L^-1 P^T
  VecX forces_;
  std::vector<int> limits_;
};

}  // namespace hazumi
