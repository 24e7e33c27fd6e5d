#pragma once

#include "engine/spatial/types.h"

namespace hazumi {

constexpr double kTouch = 1e-10;  // so near a stop counts as at it [rad]

// The stops of free hinges [rad]. A hinge that is outside has a stop where it is until it has come
// inside. [METHOD 3.6]
class StopRange {
 public:
  StopRange(VecX lower, VecX upper);

  bool any() const { return any_; }  // finite ones
  const VecX& lower() const { return lower_now_; }
  const VecX& upper() const { return upper_now_; }
  double stop(int hinge, int side) const {
    return side > 0 ? upper_now_[hinge] : lower_now_[hinge];
  }
  // No room between them.
  bool is_fixed(int hinge) const { return upper_now_[hinge] - lower_now_[hinge] <= 2.0 * kTouch; }

  // Where a motion begins.
  void Begin(const VecX& q);
  // At an event: where a ball joint passes a pole its outer hinges' angles jump, perhaps beyond
  // their stops.
  void Widen(const VecX& q);
  // As far as hinges have come inside.
  void Tighten(const VecX& q);

  // How far a hinge at q is beyond one of its stops, or its nearest one [rad]; negative inside.
  double Beyond(int hinge, int side, double q) const {
    return side > 0 ? q - upper_now_[hinge] : lower_now_[hinge] - q;
  }
  double Outside(int hinge, double q) const;

 private:
  VecX lower_, upper_;          // as given
  VecX lower_now_, upper_now_;  // widened
  bool any_ = false;
};

}  // namespace hazumi
