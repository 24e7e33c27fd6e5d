#pragma once

#include "engine/spatial/types.h"

namespace hazumi {

// Angles [rad] and rates [rad/s] of free hinges.
struct HingeState {
  explicit HingeState(int num_hinges) : q(VecX::Zero(num_hinges)), qd(VecX::Zero(num_hinges)) {}

  void swap(HingeState& other) {
    q.swap(other.q);
    qd.swap(other.qd);
  }

  VecX q, qd;
};

// What a step leaves inside of gaps of constraints and contacts: closed, or left, which is for
// searches: these look often, and can do without what a gap of the size of the tolerance changes.
enum class Gaps { kClosed, kLeft };

}  // namespace hazumi
