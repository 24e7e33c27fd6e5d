#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/region/exact/limit_rows.h"
#include "engine/spatial/types.h"

namespace hazumi {

// Joint limits that are pressed, hit or let go together. M, b: the equations of motion in the free
// hinges' coordinates, M x = T - b. `side`, by hinge: +1 at its upper limit, -1 at its lower one, 0
// at none. A limit pushes inwards only; what it does not hold moves inwards or stays.
// [METHOD 3.2, 3.3] `rows`: constraints, which are kept all the while; null: none.
//
// Both problems have one solution, since M is positive definite; it is found by principal pivots on
// the first hinge that is wrong [Murty 1974]. Calls allocate nothing once Resize was called, but
// for the first one.
class LimitSolver {
 public:
  // `tells_motion_from_rounding`: as of SolverRules.
  explicit LimitSolver(bool tells_motion_from_rounding = true)
      : tells_motion_from_rounding_(tells_motion_from_rounding) {}
  void Resize(int size);

  // An inelastic impact of everything that is at a limit, with an impulse from elsewhere [N m s]:
  // changes the rates v [rad/s] so that
  //   M dv = impulse + p,  side p <= 0,  side v <= 0,  p v = 0.
  // Hinges with `sticks` set come to rest even if that takes a pull.
  void Impact(const MatX& M, const VecX& impulse, const std::vector<int>& side,
              const std::vector<char>& sticks, VecX* v, const LimitRows* rows = nullptr);

  // Which hinges at rest at a limit stay there: sets `held` from
  //   M x + b = T,  side T <= 0,  side x <= 0,  T x = 0.
  // Hinges with `fixed` set stay, whichever way they press.
  void Rest(const MatX& M, const VecX& b, const std::vector<int>& side,
            const std::vector<char>& fixed, std::vector<char>* held,
            const LimitRows* rows = nullptr);

  // With the hinges `held` kept still: x of the others, and what the limits must give [N m].
  void Solve(const MatX& M, const VecX& b, const std::vector<char>& held,
             const LimitRows* rows = nullptr);
  const VecX& x() const { return x_; }
  const VecX& T() const { return T_; }
  const VecX& l() const { return l_; }  // what the rows give
  // Returns how much of T() is rounding [N m].
  double RoundingOf(int hinge) const { return kRounding * std::max(largest_T_, size_[hinge]); }
  // Work since the last call, in evaluations of accelerations.
  double TakeWork() { return std::exchange(work_, 0.0); }

 private:
  // Fills x_ and T_: x = given where held, T = 0 elsewhere.
  void SolveMixed(const MatX& M, const VecX& b, const VecX& given, const std::vector<char>& held,
                  const LimitRows* rows);
  void KeepRows(const LimitRows& rows, const VecX& given, const std::vector<char>& held);
  static constexpr double kRounding = 1e-12;
  // `fastest`: of what moves [rad/s] or [rad/s^2].
  int FirstWrong(const std::vector<int>& side, const VecX& reached, double fastest,
                 const std::vector<char>& fixed, const std::vector<char>& held) const;

  bool tells_motion_from_rounding_;
  MatX A_;
  VecX size_;  // of the terms that T_ is the sum of
  double largest_T_ = 0.0;
  VecX l_;
  VecX x_, T_, right_, given_, zero_, reached_, against_;
  std::vector<int> free_;
  std::vector<char> held_;
  double work_ = 0.0;
};

}  // namespace hazumi
