#pragma once

#include <optional>
#include <string>
#include <variant>

#include "engine/figure/indices.h"
#include "engine/spatial/types.h"

namespace hazumi {

enum class ForceKind { kWind, kAttract, kPush };
constexpr const char* NameOf(ForceKind kind) {
  switch (kind) {
    case ForceKind::kWind:
      return "wind";
    case ForceKind::kAttract:
      return "attract";
    case ForceKind::kPush:
      return "push";
  }
  return "";
}
// Returns whether a force acts at a point of one body (ForcePoint). Others act on all bodies.
constexpr bool ActsAtPoint(ForceKind kind) {
  return kind == ForceKind::kAttract || kind == ForceKind::kPush;
}

// Air everywhere, which moves as a whole.
struct WindForce {
  static constexpr ForceKind kKind = ForceKind::kWind;
  Vec3 velocity = Vec3::Zero();  // [m/s], world axes
  double density = 0.0;          // [kg/m^3]
  bool operator==(const WindForce&) const = default;
};

// Where a joint's body feels something; no joint: the root's.
struct ForcePoint {
  std::optional<GroupIndex> joint;
  Vec3 offset = Vec3::Zero();  // from the joint, in its frame [m]
  bool operator==(const ForcePoint&) const = default;
};

// A pull towards a place: force min(distance / radius, 1).
struct AttractForce {
  static constexpr ForceKind kKind = ForceKind::kAttract;
  ForcePoint at;
  Vec3 to = Vec3::Zero();  // [m], world
  double force = 0.0;      // [N]
  double radius = 1.0;     // [m]
  bool operator==(const AttractForce&) const = default;
};

// An impulse at the instant of the first frame.
struct PushForce {
  static constexpr ForceKind kKind = ForceKind::kPush;
  ForcePoint at;
  Vec3 impulse = Vec3::Zero();  // [N s], world axes
  bool operator==(const PushForce&) const = default;
};

// What acts on the figure's links from outside, while regions of method exact move them.
struct OuterForce {
  std::string name;
  std::variant<WindForce, AttractForce, PushForce> action;
  // Half open; of a push its frame and the next one.
  int first_frame = 0, last_frame = 0;

  ForceKind kind() const {
    return std::visit([](const auto& of_a_kind) { return of_a_kind.kKind; }, action);
  }
  bool operator==(const OuterForce&) const = default;
};

}  // namespace hazumi
