#include "ui/edit/operators/at_frame.h"

#include <algorithm>

namespace hazumi::edit {

std::optional<size_t> RegionMoving(const Animation& animation, JointIndex hinge, double frame) {
  const auto& regions = animation.regions;
  const auto found =
      std::find_if(regions.begin(), regions.end(), [&](const DynamicsRegion& region) {
        return HasTakenOver(region, frame) &&
               std::binary_search(region.joints.begin(), region.joints.end(), hinge);
      });
  if (found == regions.end()) return std::nullopt;
  return found - regions.begin();
}

bool IsSwung(const Animation& animation, JointIndex hinge, double frame) {
  return RegionMoving(animation, hinge, frame).has_value();
}

bool IsPlaced(const Animation& animation, double frame) {
  const auto& spans = animation.placements;
  return std::any_of(spans.begin(), spans.end(), [&](const PlacementSpan& span) {
    return span.kind != PlacementKind::kKeyed && HasTakenOver(span, frame);
  });
}

}  // namespace hazumi::edit
