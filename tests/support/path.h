#pragma once

// A random figure moving through time, for checks by numerical differentiation.

#include "engine/dynamics/kinematics.h"
#include "engine/figure/figure.h"
#include "tests/support/random_tree.h"

namespace hazumi::test {

// Root and joints move with constant accelerations: q(t) = q + qd t + qdd t^2 / 2.
class Path {
 public:
  explicit Path(uint64_t seed);

  const Figure& figure() const { return figure_; }
  // Positions, velocities and accelerations at time t [s].
  DynamicsWorkspace At(double t) const;
  // The pose at time 0 with one joint turned further by `angle`.
  DynamicsWorkspace WithAngleTurned(int joint, double angle) const;

  const MovingRoot& root() const { return root_; }
  const VecX& qd() const { return qd_; }
  const VecX& qdd() const { return qdd_; }

 private:
  Figure figure_;
  MovingRoot root_;
  VecX q_, qd_, qdd_;
};

// Derivative at 0 by central differences, error O(h^6).
template <typename Function>
auto Derivative(const Function& f) {
  using Value = decltype(f(0.0));
  constexpr double h = 2e-3;
  const Value d1 = f(h) - f(-h), d2 = f(2 * h) - f(-2 * h), d3 = f(3 * h) - f(-3 * h);
  return Value((0.75 * d1 - 0.15 * d2 + d3 / 60.0) / h);
}

}  // namespace hazumi::test
