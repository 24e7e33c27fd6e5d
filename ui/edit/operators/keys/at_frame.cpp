#include "ui/edit/operators/keys/at_frame.h"

#include <algorithm>

namespace hazumi::edit {

bool IsSwung(const Animation& animation, JointIndex hinge, double frame) {
  const auto& regions = animation.regions;
  return std::any_of(regions.begin(), regions.end(), [&](const DynamicsRegion& region) {
    return HasTakenOver(region, frame) &&
           std::binary_search(region.joints.begin(), region.joints.end(), hinge);
  });
}

bool IsPlaced(const Animation& animation, double frame) {
  const auto& spans = animation.placements;
  return std::any_of(spans.begin(), spans.end(), [&](const PlacementSpan& span) {
    return span.kind != PlacementKind::kKeyed && HasTakenOver(span, frame);
  });
}

}  // namespace hazumi::edit
