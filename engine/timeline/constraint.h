#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <string>

#include "engine/figure/indices.h"
#include "engine/spatial/pose.h"

namespace hazumi {

enum class ConstraintKind {
  kPoint,     // two points stay together
  kWeld,      // two frames stay together, turned alike
  kDistance,  // two points keep a distance
};
constexpr const char* NameOf(ConstraintKind kind) {
  switch (kind) {
    case ConstraintKind::kPoint:
      return "point";
    case ConstraintKind::kWeld:
      return "weld";
    case ConstraintKind::kDistance:
      return "distance";
  }
  return "";
}

// A frame that a constraint holds on to, fixed to a joint's body or in the world.
struct ConstraintEnd {
  bool is_in_world = false;
  std::optional<GroupIndex> joint;   // none: the root, unless it is in the world
  Vec3 offset = Vec3::Zero();        // of its origin in the joint's frame, or the world's [m]
  Mat3 rotation = Mat3::Identity();  // of its axes there; read by welds
  std::optional<int> object;         // object of the scene that the end is fixed to
  bool operator==(const ConstraintEnd&) const = default;
};

// What keeps two ends together while regions of method exact move at least one of them.
struct Constraint {
  std::string name;
  ConstraintKind kind = ConstraintKind::kPoint;
  ConstraintEnd a, b;
  double length = 0.0;                  // kDistance [m], positive
  int first_frame = 0, last_frame = 0;  // half open
  // A gap closes to 1 % in so many frames, without an impulse; 0: there is none to close.
  int arrive_frames = 0;
  // It breaks under more, and is gone from then on.
  std::optional<double> break_force;    // [N]
  std::optional<double> break_impulse;  // [N s]
  bool collides = false;                // whether the tied bodies collide; always for distances
  // Returns whether the tied bodies do not collide.
  bool parts() const { return !collides && kind != ConstraintKind::kDistance; }
  bool operator==(const Constraint&) const = default;
};

// How far the ends of a constraint are apart, which are at these places: the gap of its points [m],
// or of their distance, and for welds the turn between them [rad].
struct ConstraintGap {
  double distance = 0.0, turn = 0.0;
};
inline ConstraintGap GapBetween(const Constraint& constraint, const Pose& a, const Pose& b) {
  const double apart = (a.p - b.p).norm();
  if (constraint.kind == ConstraintKind::kDistance) {
    return {std::abs(apart - constraint.length), 0.0};
  }
  if (constraint.kind == ConstraintKind::kPoint) return {apart, 0.0};
  return {apart, Eigen::AngleAxisd(a.R * b.R.transpose()).angle()};
}

// A constraint without effect from a frame on, since no region moves its ends there.
struct OutlastingConstraint {
  int constraint = 0;  // index of Animation::constraints
  int from = 0;        // frame
};

}  // namespace hazumi
