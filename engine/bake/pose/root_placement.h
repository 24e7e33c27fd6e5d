#pragma once

#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/bake/pose/curve_set.h"
#include "engine/base/assert.h"
#include "engine/placement/continuous_gravity.h"
#include "engine/placement/gravity_placement.h"
#include "engine/region/region_model.h"

namespace hazumi {

// How the root's motion hangs together with the joints' while a placement acts.
struct RootHold {
  RootCoupling coupling = RootCoupling::kPrescribed;
  JointIndex pin;  // kPinned
};

// Something that a placement did by itself. `joint`: pinned by it or let go; none at an apex.
struct RootEvent {
  EventKind kind;                    // take-off, apex or landing
  double seconds = 0.0;              // since frame 0; by steps: into the step
  Vec3 pin_velocity = Vec3::Zero();  // that a landing stops in continuous time [m/s]
  std::optional<GroupIndex> joint;
};

// Where a pin is.
struct PinState {
  Vec3 pin_W = Vec3::Zero();  // [m]
  bool operator==(const PinState&) const = default;
};

// All that changes while a placement acts: nothing of a keyed one.
using RootPlacementState =
    std::variant<std::monostate, PinState, GravityPlacement::State, ContinuousGravity::State>;

// What says where the root is, from the frame where a placement begins to the one where it ends.
// Keyed and pinned ones answer at any instant. Ballistic ones have a past: they are walked through,
// by steps (PaperWalk) or from event to event (ExactWalk).
class RootPlacement {
 public:
  virtual ~RootPlacement() = default;

  // Begins with the figure as it came there.
  virtual void Begin(double /*seconds*/, const FigureMotion& /*motion*/) {}
  // Goes on from a state of this kind of placement.
  virtual void Resume(const RootPlacementState& /*state*/) {}
  virtual RootPlacementState state() const { return {}; }
  // The figure let go of something, or nothing pushes it any more: a flight begins anew.
  virtual void RenewFlight(double /*seconds*/, const FigureMotion& /*motion*/) {}

  // Contacts of a region place the figure, from now until it is taken back.
  virtual void LeaveToContacts(double /*seconds*/, const FigureMotion& /*motion*/) {}
  virtual void TakeBack(double /*seconds*/, const FigureMotion& /*motion*/) {}

  virtual bool is_keyed() const { return false; }
  // Carries the figure's momentum on.
  virtual bool is_ballistic() const { return false; }
  virtual RootHold hold() const = 0;
  // The joint that keeps its place, if one does.
  virtual std::optional<GroupIndex> pin() const { return std::nullopt; }

  // Sets the root's position, velocity and acceleration; joints and orientation are there.
  virtual void Place(double frame, Side side, FigureMotion* motion) = 0;

  // By steps: places `to`, the end of a step of so many seconds that starts at `from`, and tells
  // what happened on the way. After a landing the root moves as just before, until it is placed.
  virtual std::vector<RootEvent> Step(const FigureMotion& /*from*/, double /*seconds*/, Side side,
                                      FigureMotion* to) {
    Place(to->frame, side, to);
    return {};
  }
  // The last step ended with a landing.
  virtual bool has_landed() const { return false; }
  // An instant inside the last step. False if it is not known where the root is then.
  virtual bool PlaceWithinStep(double /*seconds_before_end*/, FigureMotion* motion) {
    Place(motion->frame, Side::kAfter, motion);
    return true;
  }

  // In continuous time: the first event in (t0, t1] [s], during which the poses are smooth.
  virtual std::optional<GravityEvent> FirstEvent(double /*t0*/, double /*t1*/,
                                                 const ContinuousGravity::Pose& /*pose*/) {
    return std::nullopt;
  }
  // Makes it happen to the figure, which is at `motion`, placed as before the event.
  virtual RootEvent Happen(const GravityEvent& event, const FigureMotion& /*motion*/) {
    HAZUMI_DEMAND(is_ballistic());  // others have no events
    return {EventKind::kApex, event.time, Vec3::Zero(), std::nullopt};
  }
};

// What placements look at and work with; all of it must outlive them.
struct RootPlacementSite {
  const Animation& animation;
  const Figure& figure;  // with what it holds at present
  CurveSet& curves;
  DynamicsWorkspace& ws;
};

// Of a span of the animation; null: where there is none. Begin or Resume is to be called first.
std::unique_ptr<RootPlacement> MakeRootPlacement(const PlacementSpan* span,
                                                 const RootPlacementSite& site);

}  // namespace hazumi
