#include "engine/placement/gravity_placement.h"

#include "engine/placement/root_placement.h"

namespace hazumi {

GravityPlacement::GravityPlacement(const Figure& figure, const std::vector<SceneObject>& scene,
                                   const PlacementSpan& span, double gravity)
    : figure_(figure), scene_(scene), span_(span), g_(0.0, 0.0, -gravity) {}

bool GravityPlacement::Touches(const std::optional<Contact>& contact) const {
  return contact && contact->clearance <= kTouching;
}

// Expects the workspace to hold the figure where the contact was found.
void GravityPlacement::PinAt(std::optional<GroupIndex> named, const Vec3& contact,
                             const DynamicsWorkspace& ws) {
  pin_ = named ? *named : NearestGroup(figure_, ws, contact);
  pin_W_ = ws.body(pin_joint()).p;
}

void GravityPlacement::MassesChanged(const FigureMotion& motion, DynamicsWorkspace* ws) {
  ComputePositions(figure_, motion.X_WR, motion.q, ws);
  ComputeVelocities(figure_, motion.root.w, motion.root.v, motion.qd, ws);
  com_ = CenterOfMass(figure_, *ws);
  com_v_ = CenterOfMassVelocity(figure_, *ws);
}

void GravityPlacement::Start(const FigureMotion& motion, DynamicsWorkspace* ws) {
  MassesChanged(motion, ws);
  const std::optional<Contact> contact = NearestContact(figure_, scene_, *ws);
  if (Touches(contact)) PinAt(span_.pin, contact->point, *ws);
}

void GravityPlacement::Advance(const FigureMotion& from, double dt, DynamicsWorkspace* ws,
                               FigureMotion* to) {
  events_.clear();
  ComputePositions(figure_, from.X_WR, from.q, ws);
  const bool was_pinned = pin_.has_value();
  bool touches_now = false;
  if (was_pinned) {
    ComputeVelocities(figure_, from.root.w, from.root.v, from.qd, ws);
    com_ = CenterOfMass(figure_, *ws);
    // After a landing: the velocity that the contact took away, or the figure would hop.
    if (!just_landed_) com_v_ = CenterOfMassVelocity(figure_, *ws);
    touches_now = Touches(NearestContact(figure_, scene_, *ws));
  }
  just_landed_ = false;
  const Vec3 tentative = com_ + com_v_ * dt + 0.5 * g_ * dt * dt;
  PlaceCenterOfMass(figure_, tentative, com_v_ + g_ * dt, ws, to);
  const Vec3 shift = to->X_WR.p;  // the workspace holds the figure with its root at the origin
  const bool touches_then = Touches(NearestContact(figure_, scene_, *ws, shift));
  if (touches_now && touches_then) {  // (3)
    PinRoot(figure_, pin_joint(), pin_W_, ws, to);
    return;
  }
  if (was_pinned) events_.push_back({EventKind::kTakeOff, 0.0});
  pin_.reset();
  const Vec3 com_from = com_, velocity = com_v_;
  Fly(tentative, dt);                                                 // (4), (5)
  if (touches_then) Land(com_from, tentative, velocity, dt, ws, to);  // (6)
}

void GravityPlacement::Place(DynamicsWorkspace* ws, FigureMotion* motion) const {
  if (pin_) {
    PinRoot(figure_, pin_joint(), pin_W_, ws, motion);
  } else {
    PlaceCenterOfMass(figure_, com_, com_v_, ws, motion);
  }
}

// The tentative pose is the next one.
void GravityPlacement::Fly(const Vec3& com, double dt) {
  const Vec3 velocity = com_v_;
  com_ = com;
  com_v_ += g_ * dt;
  if (velocity.z() > 0.0 && com_v_.z() <= 0.0) {
    events_.push_back({EventKind::kApex, velocity.z() / -g_.z()});
  }
}

// Slides the CoM back along its path to where the figure, in its pose at the end of the step, just
// touches. Where it overlaps even at the start of the path (a limb was stretched into something),
// it is moved out of what it is deepest in.
void GravityPlacement::Land(const Vec3& com_from, const Vec3& com_tentative, const Vec3& velocity,
                            double dt, DynamicsWorkspace* ws, FigureMotion* to) {
  const Vec3 path = com_tentative - com_from;
  const Vec3 start = to->X_WR.p - path;
  const double s = FirstTouchOfFigure(figure_, scene_, *ws, start, path).value_or(1.0);
  Vec3 shift = start + s * path;
  constexpr int kPushes = 32;
  for (int i = 0; i < kPushes; ++i) {
    const Contact deepest = *NearestContact(figure_, scene_, *ws, shift);
    if (deepest.clearance >= -1e-12) break;
    shift -= deepest.clearance * deepest.normal;
  }
  if (!events_.empty() && events_.back().kind == EventKind::kApex &&
      events_.back().seconds_into_step > s * dt) {
    events_.pop_back();
  }
  const Vec3 com = CenterOfMass(figure_, *ws) + shift;
  PlaceCenterOfMass(figure_, com, velocity + g_ * dt, ws, to);
  ComputePositions(figure_, to->X_WR, to->q, ws);
  com_ = com;
  PinAt(span_.landing_pin, NearestContact(figure_, scene_, *ws)->point, *ws);
  just_landed_ = true;
  events_.push_back({EventKind::kLanding, s * dt});
}

}  // namespace hazumi
