#pragma once

#include <optional>
#include <vector>

#include "engine/region/exact/contact_forces.h"
#include "engine/region/exact/impact_log.h"
#include "engine/region/exact/limit_forces.h"
#include "engine/region/exact/limit_range.h"
#include "engine/region/exact/sticky_limits.h"

namespace hazumi {

// Where an island is at a time [s].
struct HingeMoment {
  double time = 0.0;
  HingeState state;
};

// Which hinges are at a limit, and which of these it holds: found anew at each event, kept between
// them. Impacts are inelastic [METHOD 3.2]; a limit pushes and does not pull [METHOD 3.3].
class ActiveLimits {
 public:
  // Both must outlive it.
  ActiveLimits(RegionDynamics* dynamics, const LimitRange* limits);

  // Another motion: nothing is known of its events.
  void Begin();
  // Events, as StickyLimits counts them.
  void CountEvent(double t) { sticky_.CountEvent(t); }
  void ForgetEvents() { sticky_.ForgetEvents(); }
  int RecentEvents(double t) const { return sticky_.RecentEvents(t); }
  // Returns a hash of the state: hinges held by limits, touching and sliding contacts, and broken
  // constraints.
  uint64_t StateSum() const;
  // Returns whether any contact touches, including open contacts.
  bool Touches(double t, const HingeState& state);
  // Nothing holds a hinge that has room.
  void LetGo();
  // From t on, after the impact of hinges that go out and of a pin that is stopped. What rests is
  // found at `later`, if there is one.
  void Resolve(double t, const HingeMoment* later, HingeState* state, ImpactLog* log);

  // By hinge: whether a limit holds it.
  const std::vector<char>& held() const { return held_; }
  bool any() const { return any_; }
  // The latest forces are those of contacts as well.
  bool is_touching() const { return is_touching_; }
  // What rests is told with what touches, and not from a moment later.
  bool needs_later() const { return !dynamics_->mode().contacts.any_closed(); }

  // The strongest pull that a limit would have to give to hold its hinge [N m]: after Resolve, and
  // at any time.
  double StrongestPull() const;
  double PullAt(double t, const HingeState& state);
  // After PullAt: whether no limit pulls by more than rounding.
  bool PullsByRounding() const;
  // Whether those that are held would all be held there. The others are at no limit any more.
  bool WouldHoldAll(const HingeMoment& moment);

 private:
  const VecX& T() const { return is_touching_ ? contact_forces_.T() : forces_.T(); }
  int FindSides(double t, bool with_impulse, const HingeState& state, ImpactLog* log);
  void Collide(double t, HingeState* state, ImpactLog* log);
  void TellOfContacts(double t, ImpactLog* log) const;
  void CollideTied(double t, HingeState* state);
  void StopSlow(double t, HingeState* state);
  void Strike(double t, HingeState* state);
  bool stops_by_impulse() const;
  bool IsPushedOff(int hinge, const HingeState& state) const;
  // All that is at a limit, brought to rest there, and which of it limits would hold.
  struct AtRest {
    HingeState state;
    std::vector<char> held;
  };
  AtRest RestAtLimits(double t, const HingeState& state);
  bool FallsBack(double t, int hinge, const HingeState& state, std::optional<AtRest>* at_rest);
  void Settle(double t, const HingeMoment* later, HingeState* state);

  RegionDynamics* dynamics_;
  const LimitRange* limits_;
  LimitForces forces_;
  ContactForces contact_forces_;
  bool is_touching_ = false;
  std::vector<int> side_;          // the limit it is at, as LimitSolver
  std::vector<int> side_of_rest_;  // likewise, of what does not go out
  std::vector<char> held_, sticks_, fixed_, held_later_;
  bool any_ = false;
  StickyLimits sticky_;
};

}  // namespace hazumi
