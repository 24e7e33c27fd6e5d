#pragma once

#include <algorithm>

#include "engine/spatial/types.h"

namespace hazumi {

constexpr double kTouch = 1e-10;  // so near a limit counts as at it [rad]
// A hinge that far beyond its limit hits it, so that one that leaves it does not [rad].
constexpr double kHitDistance = 0.5 * kTouch;

// The limits of free hinges [rad]. A hinge that is outside has a limit where it is until it has
// come inside. [METHOD 3.6]
class LimitRange {
 public:
  LimitRange(VecX lower, VecX upper);

  bool any() const { return any_; }  // finite ones
  const VecX& lower() const { return lower_now_; }
  const VecX& upper() const { return upper_now_; }
  double limit(int hinge, int side) const {
    return side > 0 ? upper_now_[hinge] : lower_now_[hinge];
  }
  // Returns the limit once it has followed a hinge that is outside to q.
  double LimitFollowing(double q, int hinge, int side) const {
    return side > 0 ? std::max(upper_[hinge], std::min(upper_now_[hinge], q))
                    : std::min(lower_[hinge], std::max(lower_now_[hinge], q));
  }
  // Returns whether `limit` is further out than the one that was given.
  bool IsFurtherOut(double limit, int hinge, int side) const {
    return side * (limit - (side > 0 ? upper_ : lower_)[hinge]) > kHitDistance;
  }
  // No room between them.
  bool is_fixed(int hinge) const { return upper_now_[hinge] - lower_now_[hinge] <= 2.0 * kTouch; }

  // Where a motion begins.
  void Begin(const VecX& q);
  // At an event: where a ball joint passes a pole its outer hinges' angles jump, perhaps beyond
  // their limits.
  void Widen(const VecX& q);
  // As far as hinges have come inside.
  void Tighten(const VecX& q);

  // How far a hinge at q is beyond one of its limits, or its nearest one [rad]; negative inside.
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
