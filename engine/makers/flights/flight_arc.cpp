// c(t) = c0 + v t + g t^2 / 2, with v such that c(T) is where the keys have the CoM.

#include "engine/makers/flights/flight_arc.h"

#include <algorithm>

#include "engine/dynamics/kinematics.h"
#include "engine/placement/contact.h"

namespace hazumi::makers {

const MotionFrame& FrameOf(const Motion& motion, int frame) {
  const int i = std::clamp(frame - motion.frames.front().frame, 0,
                           static_cast<int>(motion.frames.size()) - 1);
  return motion.frames[i];
}

FlightArc::FlightArc(const Animation& animation, const Motion& keyed, const FlightSpan& span)
    : animation_(animation),
      keyed_(keyed),
      span_(span),
      start_(KeyedAt(span.first).com),
      gravity_(0.0, 0.0, -animation.gravity) {
  EndAt(KeyedAt(span.last).com);
}

void FlightArc::EndAt(const Vec3& com) {
  const double duration = SecondsTo(span_.last);
  velocity_ = (com - start_) / duration - 0.5 * duration * gravity_;
}

const MotionFrame& FlightArc::KeyedAt(int frame) const { return FrameOf(keyed_, frame); }

double FlightArc::SecondsTo(int frame) const {
  return animation_.rate.SecondsAt(frame - span_.first);
}

Vec3 FlightArc::ComAt(int frame) const {
  const double t = SecondsTo(frame);
  return start_ + t * velocity_ + 0.5 * t * t * gravity_;
}

Vec3 FlightArc::VelocityAt(int frame) const { return velocity_ + SecondsTo(frame) * gravity_; }

Vec3 FlightArc::RootAt(int frame) const {
  const MotionFrame& keyed = KeyedAt(frame);
  return keyed.X_WR.p + ComAt(frame) - keyed.com;
}

Vec3 FlightArc::RootVelocityAt(int frame) const {
  const MotionLimit& keyed = KeyedAt(frame).after;
  DynamicsWorkspace ws(*animation_.figure);
  ComputePositions(*animation_.figure, keyed.X_WR, keyed.q, &ws);
  ComputeVelocities(*animation_.figure, keyed.root_w, keyed.root_v, keyed.qd, &ws);
  return VelocityAt(frame) + keyed.root_v - CenterOfMassVelocity(*animation_.figure, ws);
}

std::optional<FlightArc::Nearness> FlightArc::NearnessAt(int frame) const {
  MotionFrame there = KeyedAt(frame);
  there.X_WR.p = RootAt(frame);
  return NearnessIn(there);
}

std::optional<FlightArc::Nearness> FlightArc::NearnessIn(const MotionFrame& frame) const {
  const Figure& figure = *animation_.figure;
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, frame.X_WR, frame.q, &ws);
  const std::optional<Contact> contact = NearestContact(figure, animation_.scene, ws);
  if (!contact) return std::nullopt;
  return Nearness{contact->clearance, figure.links()[contact->link].name,
                  animation_.scene[contact->object].name};
}

}  // namespace hazumi::makers
