#pragma once

#include <optional>
#include <vector>

#include "engine/region/exact/active_limits.h"
#include "engine/region/exact/contact_search.h"
#include "engine/region/exact/exact_step.h"
#include "engine/region/exact/hit_search.h"
#include "engine/region/exact/kink_search.h"
#include "engine/region/exact/mode_switch.h"
#include "engine/region/exact/release_search.h"

namespace hazumi {

// The passive motion of one island of free joints in continuous time [METHOD 2.1], with its error
// under control: steps of order 8 whose size follows the error (ExactStep), ball joints as
// quaternions, limits found inside the steps (HitSearch), hit inelastically (ActiveLimits) and let
// go when they would have to pull (ReleaseSearch).
//
// Between Advance and the next one the solver is "in" the accepted step: Sample looks inside it.
class ExactSolver {
 public:
  // `dynamics` must outlive the solver. `lower`, `upper`: limits by free hinge [rad].
  ExactSolver(RegionDynamics* dynamics, VecX lower, VecX upper);
  ExactSolver(const ExactSolver&) = delete;
  ExactSolver& operator=(const ExactSolver&) = delete;

  // As ExactStep.
  void SetTolerance(double radians, double solution_tolerance = 0.0) {
    step_.SetTolerance(radians, solution_tolerance);
  }
  void SetLongestStep(double seconds) { step_.SetLongestStep(seconds); }

  // Begins in this state, after the impulse of a pin that is stopped. A hinge that is outside its
  // limits has a limit where it is until it has come inside.
  void Start(double t, const HingeState& state);
  // Goes on from the end of the step with driven curves (or locks, or masses) that have changed.
  void Restart();

  // Advances by one step, at most to `end`. The step ends early where a limit is hit or released,
  // which the next step handles at its beginning. Where the curves hold for longer
  // (DrivenMotion::holds_until), the length of the step does not depend on `end`, and the step is
  // cut there.
  std::optional<ExactFailure> Advance(double end);

  double step_start() const { return step_.start_time(); }
  double time() const { return step_.time(); }
  // Sets the state at t in [step_start, time]; at `time` itself from the left.
  void Sample(double t, HingeState* state, Gaps gaps = Gaps::kClosed) {
    step_.Sample(t, state, gaps);
  }
  // The state at `time`, before impacts.
  const HingeState& now() const { return step_.now(); }
  // Energy and powers at t in [step_start, time], from the left.
  EnergyFlow Energy(double t) { return step_.Energy(t); }
  // Accelerations and forces at t in [step_start, time].
  InstantReport Report(double t) { return step_.Report(t); }

  // Events since the last call.
  IslandEvents TakeEvents();
  long steps() const { return steps_; }
  // Time at which time-stepping mode was entered first: from there on motions that begin nearly the
  // same end differently, however accurately they are solved.
  std::optional<double> time_stepping_from() const { return time_stepping_from_; }

 private:
  // What happens at `time`, before the next step.
  enum class Next { kGoOn, kGoOnFromCut, kEvent };

  void MakeEventHappen();
  double SmoothUntil(double end) const { return dynamics_->kinematics().SmoothUntil(end); }
  bool has_contacts() const { return dynamics_->mode().contacts.is_possible(); }
  void StepInTime();
  void FollowEvents();
  std::optional<ExactFailure> TryToAdvance(double end);
  std::optional<ExactFailure> Take(double end);
  std::optional<ExactFailure> AdvanceInTime(double end);
  void CutAt(double end);
  std::optional<ExactFailure> TakeToFirstContactChange(double end);
  bool HasLargeDefect();
  void Resolve();
  bool BreakOverloaded();
  bool FindBreak();
  void FindHits();

  RegionDynamics* dynamics_;
  LimitRange range_;
  ExactStep step_;
  ActiveLimits held_;
  HitSearch hit_search_;
  ReleaseSearch release_search_;
  ContactSearch contact_search_;
  KinkSearch kink_search_;
  TimeStepping time_stepping_;
  ModeSwitch switch_;
  ImpactLog log_;
  Next next_ = Next::kGoOn;
  int breaks_next_ = -1;  // a constraint that is overloaded at `time`
  // End of the present step in time-stepping mode; none: event-driven mode [s].
  std::optional<double> step_end_;
  std::optional<double> time_stepping_from_;  // when that mode was entered first [s]
  bool follows_event_ = false;  // the step begins with rates or forces that have jumped
  double first_start_ = 0.0;    // [s]
  long steps_ = 0;
};

}  // namespace hazumi
