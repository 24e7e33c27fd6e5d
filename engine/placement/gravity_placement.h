#pragma once

#include <optional>
#include <vector>

#include "engine/placement/contact.h"
#include "engine/placement/figure_motion.h"
#include "engine/timeline/placement_span.h"

namespace hazumi {

// Placement by gravity and contact [Arai 3.2]. While the figure touches something a joint is
// pinned; else its CoM flies on a parabola.
//
// The paper does not say which velocity the tentative pose starts from. We take the CoM's velocity
// at t_c as the rates give it. The difference quotient of two steps would lag by half a step, which
// lets a pinned figure go at -g/2 instead of -g however small the step. [METHOD 5.5]
// Beyond (5), a figure that is free at t_c and at t_d but meets something between lands on it.
class GravityPlacement {
 public:
  enum class EventKind { kTakeOff, kApex, kLanding };
  struct Event {
    EventKind kind;
    double seconds_into_step;
  };

  GravityPlacement(const Figure& figure, const std::vector<SceneObject>& scene,
                   const PlacementSpan& span, double gravity);

  // Begins at `motion`: pinned if it touches something, else in flight with the CoM velocity of
  // `motion`.
  void Start(const FigureMotion& motion, DynamicsWorkspace* ws);

  // Takes the CoM of `motion` anew after an object was let go in flight.
  void RenewFlight(const FigureMotion& motion, DynamicsWorkspace* ws);

  // Places the root of `to`, whose joint angles and root orientation are those at the end of the
  // step; `from` is the start. The root's velocity is that just before a landing.
  void Advance(const FigureMotion& from, double dt, DynamicsWorkspace* ws, FigureMotion* to);

  // Places the root of `motion` as things stand at the end of the last step, a landing done; or
  // within that step, if it did not land.
  void Place(DynamicsWorkspace* ws, FigureMotion* motion, double seconds_before_end = 0.0) const;

  // What happened in the last step. A landing comes last.
  const std::vector<Event>& events() const { return events_; }
  // The joint pinned from the end of the last step on, if any, and where.
  std::optional<GroupIndex> pin() const { return state_.pin; }
  const Vec3& pin_position() const { return state_.pin_W; }
  // True if the last step ended with a landing.
  bool has_landed() const { return state_.just_landed; }

  // All that changes from step to step.
  struct State {
    std::optional<GroupIndex> pin;
    Vec3 pin_W = Vec3::Zero();
    Vec3 com = Vec3::Zero(), com_v = Vec3::Zero();  // in flight, and just after a landing
    double clearance = 0.0;                         // at the start of the step [m]
    bool just_landed = false;
    bool operator==(const State&) const = default;
  };
  const State& state() const { return state_; }
  void Resume(const State& state) { state_ = state; }

 private:
  JointIndex pin_joint() const { return figure_.group(*state_.pin).first; }
  void PinAt(std::optional<GroupIndex> named, const Vec3& contact, const DynamicsWorkspace& ws);
  void TakeCenterOfMass(const FigureMotion& motion, DynamicsWorkspace* ws);
  void Fly(const Vec3& com, double dt);
  void MeasurePinned(const FigureMotion& motion, DynamicsWorkspace* ws);
  bool Leaves(const DynamicsWorkspace& ws, const Vec3& p, double clearance) const;
  bool PassesThrough(const DynamicsWorkspace& ws, const FigureMotion& motion,
                     const Vec3& path) const;
  void Land(const Vec3& path, const Vec3& velocity, double dt, DynamicsWorkspace* ws,
            FigureMotion* to);
  Vec3 MovedOut(const DynamicsWorkspace& ws, Vec3 shift) const;

  const Figure& figure_;
  const std::vector<SceneObject>& scene_;
  const PlacementSpan& span_;
  Vec3 g_;
  State state_;
  std::vector<Event> events_;
};

}  // namespace hazumi
