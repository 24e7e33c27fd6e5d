#include "engine/region/exact/limit_range.h"

#include <algorithm>
#include <utility>

#include "engine/spatial/checks.h"

namespace hazumi {

LimitRange::LimitRange(VecX lower, VecX upper)
    : lower_(std::move(lower)),
      upper_(std::move(upper)),
      lower_now_(lower_),
      upper_now_(upper_),
      any_(lower_.array().isFinite().any() || upper_.array().isFinite().any()) {}

void LimitRange::Begin(const VecX& q) {
  HAZUMI_ASSERT(q.size() == lower_.size() && IsFinite(q));
  lower_now_ = lower_.cwiseMin(q);
  upper_now_ = upper_.cwiseMax(q);
}

void LimitRange::Widen(const VecX& q) {
  HAZUMI_ASSERT(q.size() == lower_.size());
  constexpr double kJump = 10.0 * kTouch;
  for (int i = 0; i < static_cast<int>(q.size()); ++i) {
    if (Outside(i, q[i]) <= kJump) continue;
    lower_now_[i] = std::min(lower_now_[i], q[i]);
    upper_now_[i] = std::max(upper_now_[i], q[i]);
  }
}

void LimitRange::Tighten(const VecX& q) {
  HAZUMI_ASSERT(q.size() == lower_.size());
  for (int i = 0; i < static_cast<int>(q.size()); ++i) {
    lower_now_[i] = LimitFollowing(q[i], i, -1);
    upper_now_[i] = LimitFollowing(q[i], i, 1);
  }
}

double LimitRange::Outside(int hinge, double q) const {
  return std::max(lower_now_[hinge] - q, q - upper_now_[hinge]);
}

}  // namespace hazumi
