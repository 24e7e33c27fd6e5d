#pragma once

#include <optional>
#include <vector>

#include "engine/region/exact/exact_solver.h"
#include "engine/region/sensitivity/event_tangent.h"
#include "engine/region/sensitivity/variational_step.h"

namespace hazumi {

// A limit is hit, or lets a hinge go.
struct SensitivityEvent {
  double time = 0.0;  // [s]
  LimitEvent kind = LimitEvent::kNone;
  int hinge = 0;      // free hinge
  double rate = 0.0;  // kHit: with which it was hit [rad/s]
};

// Why a motion has no derivative, or none that is known.
struct SensitivityFailure {
  enum class Cause {
    kNoMotion,   // the solver cannot go on
    kAtPole,     // a ball joint is at a pole at an event, or where the derivative is asked for
    kOutside,    // a hinge is outside its limits, where its limit follows it
    kImpact,     // an impact that is not one on limits alone
    kNotSmooth,  // forces are not smooth between events
  } cause;
  double time;     // [s]
  int hinge = -1;  // free hinge; none: -1
};

// The motion of one island and the derivatives of its state with respect to parameters: the
// variational equations between events, saltation matrices at limits that are hit and let go.
// [METHOD 3.7] Islands without contacts, constraints and loose balls, and not in flight.
class SensitivitySolver {
 public:
  struct Tolerance {
    double motion = 1e-10;     // error of one step of the motion [rad]
    double derivative = 1e-9;  // of one step of the derivatives, relative
  };
  // `dynamics` must outlive it; nothing was evaluated with it before. Limits by free hinge [rad].
  SensitivitySolver(RegionDynamics* dynamics, const VecX& lower, const VecX& upper,
                    const Tolerance& tolerance);

  // Sets the longest step, as of ExactSolver [s].
  void SetLongestStep(double seconds) { solver_.SetLongestStep(seconds); }
  // Begins at t, moved by curves that are smooth up to `end`. D: derivatives of the state before
  // the event that may happen there, 2 n x any number: of the angles of n free hinges, then their
  // rates.
  std::optional<SensitivityFailure> Start(double t, double end, const HingeState& state,
                                          const MatX& D);
  // Curves have changed at time(), and are smooth up to `end`.
  void Restart(double end);
  // Goes on to t, at most where the curves are smooth.
  std::optional<SensitivityFailure> AdvanceTo(double t);

  double time() const { return solver_.time(); }
  // The motion at `time`, before impacts, and its derivatives, as in Start. None at a pole.
  const HingeState& now() const { return solver_.now(); }
  std::optional<MatX> Derivatives() const;

  const std::vector<SensitivityEvent>& events() const { return events_; }
  // Times, by column of D, from which on the derivative is that of one side: several limits were
  // hit at once, or a hinge began at its limit; infinity: never [s].
  const std::vector<double>& one_sided_from() const { return one_sided_from_; }

 private:
  std::optional<SensitivityFailure> Cross();
  std::optional<SensitivityFailure> FindOutside() const;
  bool HasChanged(const AfterEvent& after) const;
  AfterEvent BeginningOfStep();
  void NoteOneSided(double t, const EventJump& jump, bool at_fixed_time, const MatX& D);

  RegionDynamics* dynamics_;
  VecX lower_, upper_;
  ExactSolver solver_;
  VariationalStep step_;
  EventTangent event_;
  BeforeEvent before_;  // at the end of the latest step, or before the motion begins
  MatX X_;              // derivatives by dof of before_.layout
  double curves_start_ = 0.0, curves_end_ = 0.0;  // [s]
  bool is_fixed_time_ = true;                     // curves have changed since the latest step
  std::vector<SensitivityEvent> events_;
  std::vector<double> one_sided_from_;
};

}  // namespace hazumi
