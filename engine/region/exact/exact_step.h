#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "engine/region/exact/dop853.h"
#include "engine/region/exact/exact_reports.h"
#include "engine/region/exact/limit_range.h"
#include "engine/region/region_dynamics.h"

namespace hazumi {

inline constexpr double kSameTime = 1e-13;  // instants this near are one [s]

// Steps of order 8 through the motion of an island whose size follows the error, and the inside of
// the latest one. Knows nothing of events: whoever finds one ends the step there.
//
// The step goes from start_time() to time(), where the island is at now().
class ExactStep {
 public:
  // Both must outlive it. The limits tell the sides of ball joints.
  ExactStep(RegionDynamics* dynamics, const LimitRange* limits);

  // Error of one step: of an angle [rad]; of a rate, 1/s of it times kRateScale.
  // `solution_tolerance`, of a control solution: the same of the solution that it is compared with
  // [rad]; else 0. Both take the same step where its error is within that: kControlError times the
  // error is added to it, so that they do not err alike. [METHOD 8.2]
  void SetTolerance(double radians, double solution_tolerance) {
    tolerance_ = radians;
    solution_tolerance_ = solution_tolerance;
  }
  static constexpr double kControlError = 5.0;
  double tolerance() const { return tolerance_; }
  static constexpr double kRateScale = 20.0;  // [1/s]
  // [s]; none unless set.
  void SetLongestStep(double seconds) { longest_step_ = seconds; }

  // Another motion, from here on: nothing is known of how long its steps may be.
  void Place(double t, const HingeState& state);
  // Lays the state out anew after it, locks or curves have changed.
  void Begin();
  // One accepted step, at most to `end` [s]; of order 5 where that is near anyway.
  std::optional<ExactFailure> Take(double end, bool is_near = false);
  // Ends the step earlier, at t.
  void EndAt(double t);
  // Defect halfway to time(): the derivative of the dense output less that of the equations, times
  // the length of the whole step, in units of the tolerance. The largest of all components.
  double Defect();
  // As if it had not been taken; before anything has changed it.
  void TakeBack();
  // Goes on with the state where the step was ended as it is: next to a pole angles and rates do
  // not tell it well.
  void GoOn();

  double start_time() const { return step_.start_time(); }
  double end_time() const { return step_.end_time(); }  // before it was ended earlier
  double time() const { return time_; }
  const HingeState& start() const { return start_; }
  const HingeState& now() const { return now_; }
  HingeState& now() { return now_; }  // for events to change
  // The one that the error is largest of.
  int worst_hinge() const { return dynamics_->layout().HingeOf(step_.worst_component()); }

  // Sets the state at t in [start_time, time].
  void Sample(double t, HingeState* state, Gaps gaps = Gaps::kClosed);
  // The same of some nodes' hinges alone. Requires MakeDense.
  void SampleNodes(double t, const std::vector<int>& nodes, HingeState* state);
  void MakeDense();
  EnergyFlow Energy(double t);
  // The constraint that is overloaded most at t, or nearest to it.
  ConstraintSet::Overload WorstOverload(double t);
  // Where nodes are at the ends of a step that nothing has ended earlier, gaps left.
  RegionState PlaceStart() { return dynamics_->PlaceAt(step_.start_time(), step_.start_y()); }
  RegionState PlaceEnd() { return dynamics_->PlaceAt(step_.end_time(), step_.y()); }
  // A constraint that is singular where the step ends, as along a limb that is straight.
  std::optional<int> SingularConstraint();
  // Where nodes are at t, gaps left; and again, after it at the same t.
  RegionState Glance(double t);
  RegionState Glanced(double t) const { return dynamics_->PlacedAt(t, y_.data()); }
  // Where nodes are at time(), with now().
  RegionState PlaceNow() { return dynamics_->PlaceHinges(time_, now_); }
  // Excess of contact forces over their friction cones (RowSystem).
  RowSystem::Excess ContactExcess(double t);
  // Accelerations and forces at t in [start_time, time]; at `time` itself with now(), with which
  // the next step begins.
  InstantReport Report(double t);

 private:
  auto Field() {
    return [this](double t, const double* y, double* dy) { dynamics_->Derivative(t, y, dy); };
  }
  bool closes_gaps() const { return dynamics_->mode().any_closed(); }
  void TakeState(const double* y);
  // Evaluates the equations at t. Sets inside_ and y_.
  VecX EvaluateAt(double t, Gaps gaps);
  std::vector<ConstraintPush> ConstraintPushes() const;
  void SetScale();
  double FirstStep(double end) const;
  double Growth(double error) const;

  RegionDynamics* dynamics_;
  const LimitRange* limits_;
  double tolerance_ = 1e-6, solution_tolerance_ = 0.0;
  double longest_step_ = std::numeric_limits<double>::infinity();
  Dop853 step_;
  double next_h_ = 0.0;      // [s]; 0: not known
  double last_error_ = 1.0;  // of the step before, in units of the tolerance
  double time_ = 0.0;
  HingeState start_, now_, inside_;
  VecX y_, scale_;
  // Where constraints have closed what the step left, it goes on from there.
  VecX closed_;
  bool is_closed_ = false;
  double gap_ = 0.0;  // that constraints could not close [m, rad]
};

}  // namespace hazumi
