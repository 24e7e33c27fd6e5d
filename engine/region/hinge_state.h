#pragma once

#include <tuple>
#include <utility>

#include "engine/region/outer_motion.h"
#include "engine/spatial/types.h"

namespace hazumi {

// State of an island by its free hinges: their angles [rad] and rates [rad/s], and the motion of
// the figure as a whole and of balls.
struct HingeState {
  HingeState() = default;
  HingeState(int num_hinges, int num_balls)
      : q(VecX::Zero(num_hinges)), qd(VecX::Zero(num_hinges)) {
    outer.balls.resize(static_cast<size_t>(num_balls));
  }
  HingeState(VecX angles, VecX rates, OuterMotion motion = {})
      : q(std::move(angles)), qd(std::move(rates)), outer(std::move(motion)) {}

  void swap(HingeState& other) {
    q.swap(other.q);
    qd.swap(other.qd);
    std::swap(outer, other.outer);
    std::swap(pin_velocity, other.pin_velocity);
  }

  VecX q, qd;
  OuterMotion outer;
  Vec3 pin_velocity = Vec3::Zero();  // of a pin that the next impact stops [m/s]
};

inline auto MembersOf(const HingeState& state) {
  const auto& [q, qd, outer, pin_velocity] = state;
  return std::tie(q, qd, outer, pin_velocity);
}

// Gaps of constraints and contacts that a step leaves open by its error: closed in a sample, or
// left, which is enough for searches.
enum class Gaps { kClosed, kLeft };

}  // namespace hazumi
