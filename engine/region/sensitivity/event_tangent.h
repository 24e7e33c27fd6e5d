#pragma once

#include <optional>
#include <vector>

#include "engine/region/exact/limit_forces.h"

namespace hazumi {

// The island before an event, by free hinge.
struct BeforeEvent {
  RegionLayout layout;  // which hinges limits hold
  HingeState state;
  VecX qdd;  // [rad/s^2]; 0 of held hinges
};

// The island after it.
struct AfterEvent {
  RegionLayout layout;
  HingeState state;
  VecX velocities, accelerations;  // by dof of the layout [rad/s, rad/s^2]
};

enum class LimitEvent { kNone, kHit, kRelease };

// Effect of an event at limits on small changes of the state.
struct EventJump {
  LimitEvent kind = LimitEvent::kNone;
  int hinge = -1;     // free hinge that hits a limit or is let go, the first of several
  double rate = 0.0;  // with which it hits the limit [rad/s]
  // 2 m x 2 n: changes by dof after the event (state_tangent.h), of changes by hinge before it, at
  // the time at which it happens to the motion itself.
  MatX S;
  // Free hinges that come to rest at a limit otherwise than by the hit of `hinge`: another one is
  // hit at once, or is left and hit again. Where they depend on a parameter, or all, the derivative
  // is that of one side.
  std::vector<int> also_stopped;
  bool is_one_sided = false;
};

// The saltation matrices of events at limits. [METHOD 3.7]
class EventTangent {
 public:
  // `dynamics` must outlive it. Limits by free hinge [rad].
  EventTangent(RegionDynamics* dynamics, VecX lower, VecX upper);

  // Finds the jump of the event at t, in curves that are smooth from `start` to `end` [s].
  // `at_fixed_time`: curves change there, or the motion begins. None if the event is none of those
  // that are known: the motion after it is not what an impact on the limits that it ends at would
  // give.
  std::optional<EventJump> Find(double t, double start, double end, const BeforeEvent& before,
                                const AfterEvent& after, bool at_fixed_time);

 private:
  struct Instant {
    double t;
    VecX q, qd;
  };
  bool RatesJump(const Instant& before, const AfterEvent& after, double most) const;
  int SideAt(int hinge, double q) const;
  void ListStopped(const BeforeEvent& before, const AfterEvent& after);
  VecX Impact(const Instant& at);
  MatX ImpactDerivatives(const Instant& at);
  VecX ImpactChange(const Instant& at, double start, double end);
  std::optional<EventJump> OfHit(const Instant& at, double start, double end,
                                 const BeforeEvent& before, const AfterEvent& after);
  EventJump OfRelease(const Instant& at, double start, double end, const BeforeEvent& before,
                      const AfterEvent& after);
  VecX PullGradient(int hinge, const Instant& at);
  double PullRate(int hinge, const Instant& at, double start, double end, const VecX& qdd);
  std::optional<int> MiddleAtPole(int hinge, const Instant& at) const;
  double Pull(int hinge, const Instant& at);

  RegionDynamics* dynamics_;
  VecX lower_, upper_;
  LimitForces forces_;
  HingeState probe_;
  bool is_moved_inside_;           // driven nodes are between free ones: inertia depends on time
  std::vector<char> held_before_;  // by free hinge
  std::vector<int> stopped_;       // by free hinge: side of the limit at which it is stopped, or 0
  std::vector<char> sticks_;       // where stopped_ is not 0
};

// Returns, by free hinge, whether the layout has locked it.
std::vector<char> LockedHinges(const RegionLayout& layout);

}  // namespace hazumi
