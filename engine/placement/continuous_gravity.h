#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "engine/placement/contact.h"
#include "engine/placement/figure_motion.h"
#include "engine/timeline/placement_span.h"
#include "engine/timeline/solver_rules.h"

namespace hazumi {

struct GravityEvent {
  enum class Kind { kTakeOff, kApex, kLanding } kind;
  double time;  // [s]
  // Other than an apex, which changes nothing.
  bool is_change() const { return kind != Kind::kApex; }
};

// Placement by gravity and contact [Arai 3.2] in continuous time [METHOD 5.3-5.6]: while the figure
// touches something a joint is pinned; it takes off when the pin's normal force reaches zero or
// contact is lost, flies with its CoM on a parabola, and lands where, between any two frames, it
// first touches something.
class ContinuousGravity {
 public:
  // Joint angles, root orientation and their rates at a time; the root's position is left to us.
  using Pose = std::function<void(double seconds, FigureMotion* motion)>;

  ContinuousGravity(const Figure& figure, const std::vector<SceneObject>& scene,
                    const PlacementSpan& span, double gravity,
                    const SolverRules& rules = SolverRules(kSolverVersion));

  // Begins at `motion`: pinned if it touches something, else in flight.
  void Start(double t, const FigureMotion& motion, DynamicsWorkspace* ws);
  // The figure let go of something, or nothing pushes it any more: in flight its CoM's parabola is
  // taken anew.
  void RenewFlight(double t, const FigureMotion& motion, DynamicsWorkspace* ws);

  // Contacts of a region place the figure from here on: it flies, and has no events; until it is
  // taken back, when it begins anew where it is then.
  void LeaveToContacts(double t, const FigureMotion& motion, DynamicsWorkspace* ws);
  void TakeBack(double t, const FigureMotion& motion, DynamicsWorkspace* ws);

  // The first event in (t0, t1], during which the poses are smooth. Apexes are for the record only.
  std::optional<GravityEvent> FirstEvent(double t0, double t1, const Pose& pose,
                                         DynamicsWorkspace* ws);
  // Makes it happen to the figure, which is at `motion`, placed as before the event. Returns the
  // velocity of the pin that a landing stopped [m/s].
  Vec3 Happen(const GravityEvent& event, const FigureMotion& motion, DynamicsWorkspace* ws);

  // Places the root of `motion`: in flight as its fall says, else on the parabola.
  void Place(double t, DynamicsWorkspace* ws, FigureMotion* motion) const;

  std::optional<GroupIndex> pin() const { return state_.pin; }

  // All that changes on the way.
  struct State {
    std::optional<GroupIndex> pin;
    Vec3 pin_W = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();                    // of the ground that the figure stands on
    double start = 0.0;                             // of the flight [s]
    Vec3 com = Vec3::Zero(), com_v = Vec3::Zero();  // then
    std::vector<double> landings;                   // times of the last ones [s]
    double hold_until = -1e300;                     // no take-off before [s]
    bool is_left = false;                           // to contacts
    double allowed = 0.0;  // clearance that does not count as landing, from a deep take-off [m]
    bool operator==(const State&) const = default;
  };
  const State& state() const { return state_; }
  void Resume(const State& state) { state_ = state; }

 private:
  JointIndex pin_joint() const { return figure_.group(*state_.pin).first; }
  void PinAt(std::optional<GroupIndex> named, const Contact& contact, const DynamicsWorkspace& ws);
  void Fly(double t, const FigureMotion& motion, DynamicsWorkspace* ws);
  FigureMotion PlacedAt(double t, const Pose& pose, DynamicsWorkspace* ws) const;
  std::optional<GravityEvent> FindTakeOff(double t0, double t1, const Pose& pose,
                                          DynamicsWorkspace* ws) const;
  double Lift(double t, double t0, double t1, const Pose& pose, DynamicsWorkspace* ws) const;
  struct Rise {
    double t;      // [s]
    double speed;  // along the normal [m/s]
    int link;
  };
  Rise RiseAt(double t, const Pose& pose, DynamicsWorkspace* ws) const;
  std::optional<double> FindRise(const Rise& a, const Rise& b, const Pose& pose,
                                 DynamicsWorkspace* ws) const;
  std::optional<double> FindTop(double t0, double t1, const Pose& pose,
                                DynamicsWorkspace* ws) const;
  double RaisedGround(double clearance) const;
  std::optional<GravityEvent> FindLanding(double t0, double t1, const Pose& pose,
                                          DynamicsWorkspace* ws);
  std::optional<double> ApexIn(double t0, double t1, const Pose& pose) const;
  double ClearanceAt(double t, const Pose& pose, DynamicsWorkspace* ws) const;
  double SpeedBound(double t0, double t1, const Pose& pose, DynamicsWorkspace* ws) const;

  const Figure& figure_;
  const std::vector<SceneObject>& scene_;
  const PlacementSpan& span_;
  Vec3 g_;
  const SolverRules rules_;
  State state_;
};

}  // namespace hazumi
