#pragma once

#include <vector>

#include "engine/passive/exact/hinge_state.h"
#include "engine/passive/exact/stop_forces.h"
#include "engine/passive/exact/stop_hits.h"
#include "engine/passive/exact/stop_range.h"

namespace hazumi {

// Where an island is at a time [s].
struct HingeMoment {
  explicit HingeMoment(int num_hinges) : state(num_hinges) {}

  double time = 0.0;
  HingeState state;
};

// Which hinges are at a stop, and which of these it holds: found anew at each event, kept between
// them. Impacts are inelastic [METHOD 3.2]; a stop pushes and does not pull [METHOD 3.3].
class HeldStops {
 public:
  // Both must outlive it.
  HeldStops(RegionDynamics* dynamics, const StopRange* stops);

  // Another motion: nothing is known of its events.
  void Begin();
  // An event at t. Where they happen again and again stops become sticky, so that joints that press
  // on their stops in turn come to rest instead of chattering. [METHOD 3.5]
  void CountEvent(double t);
  // From t on, after the impact of hinges that go out and of a pin that moved with v_pin [m/s].
  // What rests is told from `later`, if there is one.
  void Resolve(double t, const Vec3& v_pin, const HingeMoment* later, HingeState* state,
               StopHits* hits);

  // By hinge: whether a stop holds it.
  const std::vector<char>& held() const { return held_; }
  bool any() const { return any_; }

  // The strongest pull that a stop would have to give to hold its hinge [N m]: after Resolve, and
  // at any time.
  double StrongestPull() const;
  double PullAt(double t, const HingeState& state);
  // Whether those that are held would all be held there. The others are at no stop any more.
  bool WouldHoldAll(const HingeMoment& moment);

 private:
  double rest_rate() const { return 30.0 * touch_; }  // slow enough to count as at rest [rad/s]
  int FindSides(double t, bool with_impulse, const HingeState& state, StopHits* hits);
  void Collide(double t, const Vec3& v_pin, HingeState* state);
  void Settle(double t, const HingeMoment* later, HingeState* state);

  const StopRange* stops_;
  StopForces forces_;
  std::vector<int> side_;  // the stop it is at, as StopSolver
  std::vector<char> held_, sticks_, fixed_, held_later_;
  bool any_ = false;
  double touch_ = kTouch;       // how near a stop counts as at it [rad]
  std::vector<double> events_;  // the latest ones [s]
};

}  // namespace hazumi
