#pragma once

#include <optional>
#include <vector>

#include "engine/figure/indices.h"
#include "engine/timeline/keyframe.h"

namespace hazumi {

// How a region moves joints of its own that are not limp.
enum class DriveKind {
  kTorque,  // by a torque over time
  kSpring,  // towards an angle
  kKeys,    // as their keys say: the others feel them
};
constexpr const char* NameOf(DriveKind kind) {
  switch (kind) {
    case DriveKind::kTorque:
      return "torque";
    case DriveKind::kSpring:
      return "spring";
    case DriveKind::kKeys:
      return "keys";
  }
  return "";
}

// Towards which angle a spring pulls.
enum class SpringTarget {
  kKeys,   // that of the joint's keys at the time
  kStart,  // that on the region's first frame
  kRest,   // the figure's rest angle
};
constexpr const char* NameOf(SpringTarget target) {
  switch (target) {
    case SpringTarget::kKeys:
      return "keys";
    case SpringTarget::kStart:
      return "start";
    case SpringTarget::kRest:
      return "rest";
  }
  return "";
}

// kTorque or kSpring: a joint that keys drive is none of its region's.
struct Drive {
  DriveKind kind = DriveKind::kTorque;
  std::vector<JointIndex> joints;  // ascending, of the region's; no joint has two drives
  Keys torque;                     // kTorque [N m]: positive accelerates the angle positively
  // kSpring: undamped it would swing with this frequency [Hz] if nothing moved but what lies beyond
  // the joint, as it is on the region's first frame; a damping ratio of 1 does not overshoot.
  SpringTarget target = SpringTarget::kKeys;
  double frequency = 0.0, damping_ratio = 0.0;
  Keys frequency_keys;               // [Hz]; in place of `frequency`, if there are any
  std::optional<double> max_torque;  // [N m]; of a ball joint the moment
  std::optional<double> strength;    // share of what the muscles of hinges can give, where known
  Keys strength_keys;                // in place of `strength`, if there are any
  bool feed_forward = false;         // and what the motion that it pulls to asks for
  bool operator==(const Drive&) const = default;
};

// Whether it is a spring as strong as a share of what muscles can give.
inline bool IsByStrength(const Drive& drive) {
  return drive.strength.has_value() || !drive.strength_keys.empty();
}

// Whether what moves a joint follows its keys all the way, so that its curve arrives at the region
// as if that were not there.
inline bool FollowsKeys(const Drive& drive) {
  return drive.kind == DriveKind::kSpring && drive.target == SpringTarget::kKeys;
}

}  // namespace hazumi
