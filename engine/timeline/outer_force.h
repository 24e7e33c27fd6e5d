#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>

#include "engine/figure/indices.h"
#include "engine/spatial/types.h"

namespace hazumi {

// At sea level and 15 degrees [kg/m^3].
inline constexpr double kDensityOfAir = 1.225;

// Air everywhere, which moves as a whole.
struct WindForce {
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
  ForcePoint at;
  Vec3 to = Vec3::Zero();  // [m], world
  double force = 0.0;      // [N]
  double radius = 1.0;     // [m]
  bool operator==(const AttractForce&) const = default;
};

// An impulse at the instant of the first frame.
struct PushForce {
  ForcePoint at;
  Vec3 impulse = Vec3::Zero();  // [N s], world axes
  bool operator==(const PushForce&) const = default;
};

// The action of a force: one struct for each kind, in the order of ForceKind.
using ForceAction = std::variant<WindForce, AttractForce, PushForce>;
enum class ForceKind { kWind, kAttract, kPush };
inline constexpr std::array kForceKinds = {"wind", "attract", "push"};
static_assert(kForceKinds.size() == std::variant_size_v<ForceAction>);

constexpr const char* NameOf(ForceKind kind) { return kForceKinds[static_cast<size_t>(kind)]; }
constexpr ForceKind KindOf(const ForceAction& action) {
  return static_cast<ForceKind>(action.index());
}

// Returns the action of a new force: a breeze; a pull to a place one metre ahead; a push from
// behind.
inline ForceAction NewAction(ForceKind kind) {
  const std::array<ForceAction, kForceKinds.size()> all = {
      WindForce{Vec3(3.0, 0.0, 0.0), kDensityOfAir},
      AttractForce{{}, Vec3(1.0, 0.0, 1.0), 40.0, 0.5}, PushForce{{}, Vec3(5.0, 0.0, 0.0)}};
  return all[static_cast<size_t>(kind)];
}

// Returns where a force acts that acts at a point of one body. Null: it acts on all bodies.
inline ForcePoint* ForcePointOf(ForceAction* action) {
  return std::visit(
      [](auto& of_a_kind) -> ForcePoint* {
        if constexpr (requires { of_a_kind.at; }) return &of_a_kind.at;
        return nullptr;
      },
      *action);
}
inline const ForcePoint* ForcePointOf(const ForceAction& action) {
  return ForcePointOf(const_cast<ForceAction*>(&action));
}

// What acts on the figure's links from outside, while regions of method exact move them.
struct OuterForce {
  std::string name;
  ForceAction action;
  // Half open; of a push its frame and the next one.
  int first_frame = 0, last_frame = 0;

  ForceKind kind() const { return KindOf(action); }
  bool operator==(const OuterForce&) const = default;
};

}  // namespace hazumi
