#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/region/exact/dop853.h"
#include "engine/region/exact/exact_solver.h"

namespace hazumi {

// The variational equations of an island along the latest step of its solver, between events:
// d/dt dx = D_x f dx, dx by dof (state_tangent.h).
class VariationalStep {
 public:
  // `dynamics` must outlive it. `tolerance`: error of one step of the equations, relative to the
  // largest entry of a column; of rates 20/s times that.
  VariationalStep(RegionDynamics* dynamics, double tolerance);

  // Takes the columns of X, 2 m x any number, from a to b [s], both in the latest step of `solver`.
  // False if D_x f is not smooth there, so that no short interval is fitted.
  bool Advance(double a, double b, ExactSolver* solver, MatX* X);

 private:
  static constexpr int kPoints = 6;

  void FindKinksAt(double t, ExactSolver* solver, std::vector<double>* kinks);
  std::optional<double> FirstKink(double a, double b, ExactSolver* solver);
  double KinkBetween(size_t kink, double a, double at_a, double b, double at_b,
                     ExactSolver* solver);
  bool AdvanceInParts(double a, double b, int halvings, ExactSolver* solver, MatX* X);
  bool Fit(double a, double b, ExactSolver* solver);
  void LinearizeAt(double t, MatX* D);
  VecX DifferenceAt(double t, int column);
  VecX AccelerationsAt(double t, int column, double change);
  VecX TurnSteps() const;
  bool IsBeyondKink() const;
  void Derive(double t, const double* X, double* dX, Eigen::Index columns);
  bool Integrate(double a, double b, MatX* X);

  RegionDynamics* dynamics_;
  double tolerance_;
  double a_ = 0.0, b_ = 0.0;  // of the fit [s]
  // Coefficients of Legendre polynomials of [D_q a, D_v a, v], m x (2 m + 1): derivatives of the
  // accelerations by turns and velocities, and the velocities.
  std::array<MatX, kPoints> fit_;
  MatX now_;  // their sum at one time
  Dop853 steps_;
  VecX y_, shifted_, change_, here_, dy_, scale_, steps_of_turns_;
  HingeState sample_;
  std::array<std::vector<double>, 9> looks_;  // for kinks, into an interval
  std::vector<double> kinks_, kinks_here_;
};

}  // namespace hazumi
