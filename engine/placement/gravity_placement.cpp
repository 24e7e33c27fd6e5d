#include "engine/placement/gravity_placement.h"

#include <algorithm>
#include <cmath>

#include "engine/placement/figure_motion.h"

namespace hazumi {

namespace {

constexpr double kSameDepth = 1e-12;  // [m]

// When something that is thrown upwards with velocity v has risen by `rise`: of the two times that
// which is nearer to `guess`, or `guess` if it never rises so far. `g` points downwards.
double SecondsUntilRisen(double rise, double v, double g, double guess) {
  const double square = v * v - 2.0 * g * rise;
  if (g <= 0.0 || square < 0.0) return guess;
  const double up = (v - std::sqrt(square)) / g, down = (v + std::sqrt(square)) / g;
  return std::abs(up - guess) < std::abs(down - guess) ? up : down;
}

}  // namespace

GravityPlacement::GravityPlacement(const Figure& figure, const std::vector<SceneObject>& scene,
                                   const PlacementSpan& span, double gravity)
    : figure_(figure), scene_(scene), span_(span), g_(0.0, 0.0, -gravity) {}

// Expects the workspace to hold the figure where the contact was found.
void GravityPlacement::PinAt(std::optional<GroupIndex> named, const Vec3& contact,
                             const DynamicsWorkspace& ws) {
  state_.pin = named ? *named : NearestGroup(figure_, ws, contact);
  state_.pin_W = ws.body(pin_joint()).p;
}

void GravityPlacement::TakeCenterOfMass(const FigureMotion& motion, DynamicsWorkspace* ws) {
  ComputePositions(figure_, motion.X_WR, motion.q, ws);
  ComputeVelocities(figure_, motion.root.w, motion.root.v, motion.qd, ws);
  state_.com = CenterOfMass(figure_, *ws);
  state_.com_v = CenterOfMassVelocity(figure_, *ws);
}

// While pinned every step takes it anew, but for the velocity that a landing left.
void GravityPlacement::RenewFlight(const FigureMotion& motion, DynamicsWorkspace* ws) {
  if (!state_.pin) TakeCenterOfMass(motion, ws);
}

void GravityPlacement::Start(const FigureMotion& motion, DynamicsWorkspace* ws) {
  TakeCenterOfMass(motion, ws);
  state_.clearance = Clearance(figure_, scene_, *ws);
  if (state_.clearance <= kTouching)
    PinAt(span_.pin, NearestContact(figure_, scene_, *ws)->point, *ws);
}

void GravityPlacement::Advance(const FigureMotion& from, double dt, DynamicsWorkspace* ws,
                               FigureMotion* to) {
  events_.clear();
  const bool was_pinned = state_.pin.has_value();
  if (was_pinned) MeasurePinned(from, ws);
  const bool touches = was_pinned && state_.clearance <= kTouching;
  state_.just_landed = false;
  const Vec3 com = state_.com, velocity = state_.com_v;
  const Vec3 path = velocity * dt + 0.5 * g_ * dt * dt;
  PlaceCenterOfMass(figure_, com + path, velocity + g_ * dt, ws, to);
  const double clearance = Clearance(figure_, scene_, *ws, to->X_WR.p);
  if (touches && !Leaves(*ws, to->X_WR.p, clearance)) {  // (3)
    PinRoot(figure_, pin_joint(), state_.pin_W, ws, to);
    return;
  }
  if (was_pinned) events_.push_back({EventKind::kTakeOff, 0.0});
  state_.pin.reset();
  Fly(com + path, dt);  // (4), (5)
  // A figure that took off from a hair inside the ground is stopped only if it goes deeper.
  const bool is_deeper = clearance <= std::min(state_.clearance, 0.0) + kSameDepth;
  state_.clearance = clearance;
  const bool is_stopped = is_deeper || (clearance > 0.0 && PassesThrough(*ws, *to, path));
  if (!touches && is_stopped) Land(path, velocity, dt, ws, to);  // (6)
}

// Takes the CoM of a pinned figure and its clearance.
void GravityPlacement::MeasurePinned(const FigureMotion& motion, DynamicsWorkspace* ws) {
  const Vec3 before_landing = state_.com_v;
  TakeCenterOfMass(motion, ws);
  // After a landing: the velocity that the contact took away, or the figure would hop.
  if (state_.just_landed) state_.com_v = before_landing;
  state_.clearance = Clearance(figure_, scene_, *ws);
}

// Whether a standing figure gets free with its tentative root at p: higher than its pin would have
// it, so that a hair above or inside the ground is as good as on it, and not through the ground.
// The workspace, here and below, holds the figure with its root at the origin.
bool GravityPlacement::Leaves(const DynamicsWorkspace& ws, const Vec3& p, double clearance) const {
  const Vec3 pinned = state_.pin_W - ws.body(pin_joint()).p;
  const Contact contact = *NearestContact(figure_, scene_, ws, pinned);
  return clearance > std::max(contact.clearance, -kTouching) + kSameDepth &&
         contact.normal.dot(p - pinned) > 0.0;
}

// Whether a figure that is free at both ends of the path that led to `motion` met something on it.
bool GravityPlacement::PassesThrough(const DynamicsWorkspace& ws, const FigureMotion& motion,
                                     const Vec3& path) const {
  const Vec3 start = motion.X_WR.p - path;
  if (Clearance(figure_, scene_, ws, start) <= kTouching) return false;
  return FirstTouchOfFigure(figure_, scene_, ws, start, path).has_value();
}

void GravityPlacement::Place(DynamicsWorkspace* ws, FigureMotion* motion,
                             double seconds_before_end) const {
  if (state_.pin) {
    PinRoot(figure_, pin_joint(), state_.pin_W, ws, motion);
  } else {
    const double t = -seconds_before_end;
    PlaceCenterOfMass(figure_, state_.com + state_.com_v * t + 0.5 * g_ * t * t,
                      state_.com_v + g_ * t, ws, motion);
  }
}

// The tentative pose is the next one.
void GravityPlacement::Fly(const Vec3& com, double dt) {
  const Vec3 velocity = state_.com_v;
  state_.com = com;
  state_.com_v += g_ * dt;
  if (velocity.z() > 0.0 && state_.com_v.z() <= 0.0) {
    events_.push_back({EventKind::kApex, velocity.z() / -g_.z()});
  }
}

// Slides the CoM back along its path to where the figure, in its pose at the end of the step, just
// touches. Where it overlaps even at the start of the path (a limb was stretched into something),
// it is moved out of what it is deepest in.
void GravityPlacement::Land(const Vec3& path, const Vec3& velocity, double dt,
                            DynamicsWorkspace* ws, FigureMotion* to) {
  const Vec3 start = to->X_WR.p - path;
  const double s = FirstTouchOfFigure(figure_, scene_, *ws, start, path).value_or(1.0);
  const Vec3 shift = MovedOut(*ws, start + s * path);
  const double seconds =
      std::clamp(SecondsUntilRisen(s * path.z(), velocity.z(), -g_.z(), s * dt), 0.0, dt);
  std::erase_if(events_, [&](const Event& event) { return event.seconds_into_step > seconds; });
  state_.com = CenterOfMass(figure_, *ws) + shift;
  PlaceCenterOfMass(figure_, state_.com, velocity + g_ * dt, ws, to);
  ComputePositions(figure_, to->X_WR, to->q, ws);
  PinAt(span_.landing_pin, NearestContact(figure_, scene_, *ws)->point, *ws);
  state_.just_landed = true;
  events_.push_back({EventKind::kLanding, seconds});
}

// Where the figure, moved by `shift`, no longer overlaps anything.
Vec3 GravityPlacement::MovedOut(const DynamicsWorkspace& ws, Vec3 shift) const {
  constexpr int kPushes = 32;
  for (int i = 0; i < kPushes; ++i) {
    const Contact deepest = *NearestContact(figure_, scene_, ws, shift);
    if (deepest.clearance >= -1e-12) break;
    shift -= deepest.clearance * deepest.normal;
  }
  return shift;
}

}  // namespace hazumi
