#pragma once

#include "engine/region/exact/active_limits.h"
#include "engine/region/exact/time_stepping.h"

namespace hazumi {

// Decides in which of two modes contacts and limits are solved [METHOD 12.4]: from event to event,
// or by time stepping. Time stepping is entered where
//   something begins inside something,
//   contacts of a large island touch, which are solved by tree,
//   more than kMostEvents events fall into 1/30 s,
//   no step succeeds, since sliding jams, or springs are stiff; or many short steps do.
// It is left once it is calm (TimeStepping::is_calm).
class ModeSwitch {
 public:
  // All must outlive this object.
  ModeSwitch(const RegionDynamics* dynamics, ActiveLimits* limits, TimeStepping* stepping)
      : dynamics_(dynamics), limits_(limits), stepping_(stepping) {}

  // Event-driven mode begins at t [s], after so many steps.
  void BeginEvents(double t, long steps) {
    slow_from_ = t;
    steps_before_ = steps;
  }
  // Whether to enter time-stepping mode: at the start of a motion, where contacts or limits are to
  // be resolved, after an event, before a step, and after a step that failed.
  bool EntersAtStart(double t, const HingeState& state) {
    return contacts().is_possible() && stepping_->IsAnyInside(t, state);
  }
  bool EntersAtTouch(double t, const HingeState& state) {
    return dynamics_->solves_contacts_by_tree() && limits_->Touches(t, state);
  }
  bool EntersAfterEvent(double t) const {
    constexpr int kMostEvents = 6;
    if (!contacts().is_possible() || contacts().pairs().empty()) return false;
    return limits_->RecentEvents(t) > kMostEvents;
  }
  bool EntersBeforeStep(double t, long steps) {
    constexpr int kMostShortSteps = 30, kMostOnSprings = 5;
    constexpr double kWhile = 5e-3;  // [s]
    if (!may_enter()) return false;
    if (t > slow_from_ + kWhile) BeginEvents(t, steps);
    return steps > steps_before_ + (has_implicit_springs() ? kMostOnSprings : kMostShortSteps);
  }
  bool EntersAfterFailure() const { return may_enter(); }
  // Whether to leave it.
  bool Leaves() const { return stepping_->is_calm(); }

 private:
  const ContactSet& contacts() const { return dynamics_->mode().contacts; }
  bool has_implicit_springs() const {
    return dynamics_->has_implicit_springs() && contacts().is_possible();
  }
  bool may_enter() const { return has_implicit_springs() || contacts().any_closed(); }

  const RegionDynamics* dynamics_;
  ActiveLimits* limits_;
  TimeStepping* stepping_;
  double slow_from_ = 0.0;  // [s]
  long steps_before_ = 0;   // up to there
};

}  // namespace hazumi
