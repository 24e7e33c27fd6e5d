#pragma once

#include <vector>

#include "engine/region/exact/limit_solver.h"
#include "engine/region/region_dynamics.h"

namespace hazumi {

// What limits do to the free hinges of an island: all of it as one problem, or, of a large island,
// of those that are at a limit alone. By free hinge; `side` as LimitSolver has it.
class LimitForces {
 public:
  // `dynamics` must outlive it.
  explicit LimitForces(RegionDynamics* dynamics);

  // An impact of what goes out, of a pin that is stopped, and of ends of constraints that part.
  // Changes the rates. kHingesAlone: the pin and ends of constraints keep theirs.
  enum class Strikes { kAll, kHingesAlone };
  void Impact(double t, const std::vector<int>& side, const std::vector<char>& sticks,
              HingeState* state, Strikes strikes = Strikes::kAll);
  // Which hinges at rest at a limit stay there.
  void Rest(double t, const HingeState& state, const std::vector<int>& side,
            const std::vector<char>& fixed, std::vector<char>* held);
  // With the hinges `held` kept still.
  void Hold(double t, const HingeState& state, const std::vector<char>& held);
  // After Impact: the impulses of constraints' rows [N s, N m s].
  const VecX& row_impulses() const { return solver_.l(); }
  // After Rest and Hold: accelerations, but of large islands, and what the limits give [N m].
  const VecX& x() const { return solver_.x(); }
  const VecX& T() const { return dynamics_->is_large() ? T_ : solver_.T(); }
  // Returns how much of T() is rounding, by free hinge [N m].
  double RoundingOf(int hinge) const {
    return dynamics_->is_large() ? roundings_[hinge] : solver_.RoundingOf(hinge);
  }

 private:
  template <typename IsWanted>
  SomeHinges AssembleSome(double t, const HingeState& state, IsWanted&& is_wanted);
  void TakeTorques();

  RegionDynamics* dynamics_;
  LimitSolver solver_;
  VecX impulse_;
  // Of a large island: the hinges that are looked at, and what is known of them.
  std::vector<int> some_, side_;
  std::vector<char> flags_, held_;
  VecX T_, roundings_;
};

}  // namespace hazumi
