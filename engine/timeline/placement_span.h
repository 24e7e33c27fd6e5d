#pragma once

#include <optional>
#include <vector>

#include "engine/figure/figure.h"

namespace hazumi {

// How the figure's position in the world is found (Arai 3). Frames not covered by any span are
// keyed. The root's orientation is keyed always.
enum class PlacementKind {
  kKeyed,    // the root's position curves
  kPinned,   // a joint stays where it is (Arai 3.1)
  kGravity,  // gravity and contact (Arai 3.2)
};
constexpr const char* NameOf(PlacementKind kind) {
  switch (kind) {
    case PlacementKind::kKeyed:
      return "keyed";
    case PlacementKind::kPinned:
      return "pinned";
    case PlacementKind::kGravity:
      return "gravity";
  }
  return "";
}

struct PlacementSpan {
  PlacementKind kind = PlacementKind::kKeyed;
  int first_frame = 0;
  int last_frame = 0;  // half open, as for regions
  // kPinned: the pinned joint. kGravity: the joint pinned while touching before the first take-off;
  // none: the nearest to the contact.
  std::optional<GroupIndex> pin;
  // kGravity: the joint pinned after a landing; none: the nearest to the contact.
  std::optional<GroupIndex> landing_pin;
  bool operator==(const PlacementSpan&) const = default;
};

// Of two spans that follow each other, these or a document's: a flight by gravity leaves a pin, at
// once or after a few frames that are keyed, until the figure is off the ground; and it ends on
// one.
template <typename Span>
bool LeavesPin(const Span& before, const Span& flight) {
  constexpr int kOnTheWay = 3;  // frames
  return before.kind == PlacementKind::kPinned && flight.kind == PlacementKind::kGravity &&
         flight.first_frame >= before.last_frame &&
         flight.first_frame <= before.last_frame + kOnTheWay;
}
template <typename Span>
bool EndsOnPin(const Span& flight, const Span& after) {
  return flight.kind == PlacementKind::kGravity && after.kind == PlacementKind::kPinned &&
         after.first_frame == flight.last_frame;
}

// A jump: a flight by gravity from one pin to another, by indices of spans.
struct JumpSpans {
  size_t before = 0, flight = 0, after = 0;
};
// Returns the jump that a frame is in, its last frame excluded.
template <typename Span>
std::optional<JumpSpans> JumpAt(double frame, const std::vector<Span>& all) {
  for (size_t i = 0; i + 2 < all.size(); ++i) {
    const Span &before = all[i], &flight = all[i + 1], &after = all[i + 2];
    // Room for each phase to have a frame of its own.
    const bool is_long = before.last_frame - before.first_frame >= 2 &&
                         flight.last_frame - before.last_frame >= 3 &&
                         after.last_frame - after.first_frame >= 2;
    const bool is_here = frame >= before.first_frame && frame < after.last_frame;
    const bool is_flight = LeavesPin(before, flight) && EndsOnPin(flight, after);
    if (is_flight && is_long && is_here) return JumpSpans{i, i + 1, i + 2};
  }
  return std::nullopt;
}

// Which joints inverse kinematics moves to hold one.
enum class HoldReach {
  kLimb,  // its limb, which ends before a joint that carries others too (ChainOf)
  kBody,  // all up to the root
};
constexpr const char* NameOf(HoldReach reach) {
  switch (reach) {
    case HoldReach::kLimb:
      return "limb";
    case HoldReach::kBody:
      return "body";
  }
  return "";
}

// Inverse kinematics: the joint stays where it was at `first_frame`, up to and including the moment
// of `last_frame`. Joints between the root and it are solved, the keyed pose picks the branch.
struct IkHold {
  GroupIndex joint;
  int first_frame = 0;
  int last_frame = 0;
  bool hold_orientation = false;  // also of the body that the joint sits on
  HoldReach reach = HoldReach::kLimb;
  bool operator==(const IkHold&) const = default;
};

// The joints that a hold moves, from it towards the root.
inline std::vector<GroupIndex> SolvedJoints(const IkHold& hold, const Figure& figure) {
  constexpr int kAll = 0;
  if (hold.reach == HoldReach::kBody) return ChainOf(hold.joint, kAll, figure);
  return ChainOf(hold.joint, std::nullopt, figure);
}

}  // namespace hazumi
