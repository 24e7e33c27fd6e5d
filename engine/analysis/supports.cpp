// Contact points of a pin that touches nothing: something outside the scene supports the body
// beyond the joint. Below the centre of mass the support is ground: the lowest points of the body
// stand on it, with weights that fall from 1 at the lowest point to 0 at kRoll above. Above the
// centre of mass the support is a grip.

#include "engine/analysis/supports.h"

#include <algorithm>
#include <limits>
#include <variant>

#include "engine/collision/distance.h"

namespace hazumi {

namespace {

constexpr double kThin = 0.06;  // largest thickness that a hand can close around [m]

bool IsThin(const Obstacle& shape) {
  if (const auto* rod = std::get_if<Capsule>(&shape)) return 2.0 * rod->radius <= kThin;
  const auto* box = std::get_if<Box>(&shape);
  if (!box) return false;
  Vec3 size = 2.0 * box->half_size;
  std::sort(size.begin(), size.end());
  return size[1] <= kThin;
}

}  // namespace

JointIndex HeldJoint(const ConstraintEnd& end, const Figure& figure) {
  return end.joint ? figure.group(*end.joint).last() : JointIndex();
}

Vec3 HeldPlace(const ConstraintEnd& end, const Figure& figure, const PlacedFrame& placed) {
  return placed.PointOf(HeldJoint(end, figure), end.offset);
}

Supports::Supports(const Animation& animation, size_t num_frames, const TouchLimits& limits)
    : animation_(animation), limits_(limits), touching_(animation, num_frames, limits) {
  for (const SceneObject& object : animation.scene) {
    if (IsThin(object.shape)) thin_.push_back(object.shape);
  }
}

void Supports::PointsAt(const SupportedFrame& at, std::vector<ContactPoint>* points) const {
  points->clear();
  if (IsInFlight(at)) return;
  touching_.PointsAt(at.index, at.placed, points);
  std::erase_if(*points, [&](const ContactPoint& point) {
    return IsHeld(point, at) || IsKnown(point.joint, at.frame.contacts);
  });
  AddHolds(at, points);
  AddPin(at, points);
  std::sort(points->begin(), points->end(),
            [](const ContactPoint& a, const ContactPoint& b) { return a.id < b.id; });
}

// Returns whether gravity places the figure without a pin. The last frame of a placement belongs to
// the next placement.
bool Supports::IsInFlight(const SupportedFrame& at) const {
  if (at.frame.pinned) return false;
  return std::any_of(animation_.placements.begin(), animation_.placements.end(),
                     [&](const PlacementSpan& span) {
                       return span.kind == PlacementKind::kGravity &&
                              HasInstant(span.first_frame, span.last_frame, at.animation_frame,
                                         animation_.last_frame);
                     });
}

// Returns whether a constraint already supplies the force at a point, as for a hand that hangs on a
// rail. Such points lie on the body beyond the constrained joint or near the constrained end.
bool Supports::IsHeld(const ContactPoint& point, const SupportedFrame& at) const {
  constexpr double kNear = 0.15;  // [m]
  const Figure& figure = *animation_.figure;
  const auto holds = [&](const ConstraintEnd& end) {
    if (end.is_in_world) return false;
    const JointIndex joint = HeldJoint(end, figure);
    const bool is_beyond = point.joint == joint || (joint.is_valid() && point.joint.is_valid() &&
                                                    figure.IsBeyond(point.joint, joint));
    return is_beyond || (point.p - HeldPlace(end, figure, at.placed)).norm() < kNear;
  };
  for (size_t i = 0; i < at.frame.constraint_pushes.size(); ++i) {
    const Wrench& push = at.frame.constraint_pushes[i];
    if (push.force.isZero(0.0) && push.moment.isZero(0.0)) continue;
    if (holds(animation_.constraints[i].a) || holds(animation_.constraints[i].b)) return true;
  }
  return false;
}

// Returns whether the contact forces on a joint's links are known, so that none are solved for.
bool Supports::IsKnown(JointIndex joint, const SceneContacts& contacts) const {
  const auto& links = animation_.figure->links();
  for (size_t i = 0; i < contacts.is_known.size(); ++i) {
    if (contacts.is_known[i] && links[i].joint == joint) return true;
  }
  return false;
}

void Supports::AddHolds(const SupportedFrame& at, std::vector<ContactPoint>* points) const {
  for (const IkHold& hold : animation_.holds) {
    const bool acts =
        hold.first_frame <= at.animation_frame && at.animation_frame <= hold.last_frame;
    if (acts) Grip(animation_.figure->group(hold.joint).last(), at, points);
  }
}

void Supports::AddPin(const SupportedFrame& at, std::vector<ContactPoint>* points) const {
  if (!at.frame.pinned) return;
  const JointIndex joint = animation_.figure->group(*at.frame.pinned).last();
  if (IsKnown(joint, at.frame.contacts) || Grip(joint, at, points)) return;
  const bool touches = std::any_of(points->begin(), points->end(), [&](const ContactPoint& point) {
    return point.joint.is_valid() && animation_.figure->IsBeyond(point.joint, joint);
  });
  if (touches) return;
  if (at.placed.p(joint).z() < at.frame.com.z()) {
    StandOn(joint, at, points);
  } else {
    AddGrip(joint, at, points);
  }
}

bool Supports::Grip(JointIndex joint, const SupportedFrame& at,
                    std::vector<ContactPoint>* points) const {
  if (thin_.empty()) return false;
  const auto reaches = [&](const Touching::End& end) {
    const Vec3 centre = at.placed.PointOf(end.joint, end.centre);
    return std::any_of(thin_.begin(), thin_.end(), [&](const Obstacle& thin) {
      return SignedDistance(Capsule{centre, centre, end.radius}, thin).value <= limits_.clearance;
    });
  };
  const std::vector<Touching::End> ends = touching_.EndsBeyond(joint);
  if (std::none_of(ends.begin(), ends.end(), reaches)) return false;
  std::erase_if(*points, [&](const ContactPoint& point) {
    return point.joint.is_valid() && animation_.figure->IsBeyond(point.joint, joint);
  });
  AddGrip(joint, at, points);
  return true;
}

void Supports::AddGrip(JointIndex joint, const SupportedFrame& at,
                       std::vector<ContactPoint>* points) const {
  ContactPoint& grip = points->emplace_back();
  grip.joint = joint;
  grip.p = at.placed.p(joint);
  grip.is_grip = true;
  grip.id = std::numeric_limits<int>::max() - animation_.figure->num_joints() + joint.value();
}

void Supports::StandOn(JointIndex joint, const SupportedFrame& at,
                       std::vector<ContactPoint>* points) const {
  constexpr double kRoll = 0.02;  // [m]
  const std::vector<Touching::End> ends = touching_.EndsBeyond(joint);
  const auto height = [&](const Touching::End& end) {
    return at.placed.PointOf(end.joint, end.centre).z() - end.radius;
  };
  double lowest = std::numeric_limits<double>::max();
  for (const Touching::End& end : ends) lowest = std::min(lowest, height(end));
  for (const Touching::End& end : ends) {
    const double above = (height(end) - lowest) / kRoll;
    if (above >= 1.0) continue;
    Touching::AddSides(end, at.placed, Vec3::UnitZ(), FadeIn(1.0 - above), points);
  }
  if (!ends.empty()) return;
  AddGrip(joint, at, points);  // place a body without a shape on its joint
  points->back().is_grip = false;
}

}  // namespace hazumi
