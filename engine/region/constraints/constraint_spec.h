#pragma once

#include <optional>
#include <tuple>

#include "engine/timeline/constraint.h"

namespace hazumi {

// A frame that a constraint holds on to, fixed to a node of a model or in the world.
struct ConstraintSeat {
  static constexpr int kWorld = -1;
  int node = kWorld;
  Vec3 p = Vec3::Zero();      // of its origin, in the node's frame or the world's [m]
  Mat3 R = Mat3::Identity();  // of its axes there
};
inline auto MembersOf(const ConstraintSeat& seat) {
  const auto& [node, p, R] = seat;
  return std::tie(node, p, R);
}

// A constraint of an island, as plain values that caches compare.
struct ConstraintSpec {
  ConstraintKind kind = ConstraintKind::kPoint;
  ConstraintSeat a, b;
  double length = 0.0;        // kDistance [m]
  double closing_rate = 0.0;  // with which a gap closes [1/s]; 0: there is none
  std::optional<double> break_force, break_impulse;  // [N], [N s]
};
inline auto MembersOf(const ConstraintSpec& spec) {
  const auto& [kind, a, b, length, closing_rate, break_force, break_impulse] = spec;
  return std::tie(kind, a, b, length, closing_rate, break_force, break_impulse);
}

// A constraint that broke, at a time [s].
struct ConstraintBreak {
  int constraint;
  double time;
};

}  // namespace hazumi
