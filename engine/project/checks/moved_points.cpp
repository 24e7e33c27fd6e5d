#include "engine/project/checks/moved_points.h"

#include <algorithm>

namespace hazumi {

namespace {

bool IsBeyondAny(JointIndex j, const DynamicsRegion& region, const Figure& figure) {
  return std::any_of(region.joints.begin(), region.joints.end(),
                     [&](JointIndex moved) { return figure.IsBeyond(j, moved); });
}

// Whether the root's place may answer what the region's joints do.
bool MayMoveRoot(const DynamicsRegion& region, const Animation& animation) {
  const Figure& figure = *animation.figure;
  return std::any_of(animation.placements.begin(), animation.placements.end(),
                     [&](const PlacementSpan& span) {
                       if (Common(SpanOf(span), SpanOf(region)).is_empty()) return false;
                       if (span.kind == PlacementKind::kGravity) return true;
                       return span.kind == PlacementKind::kPinned && span.pin &&
                              IsBeyondAny(figure.group(*span.pin).first, region, figure);
                     });
}

}  // namespace

bool MayMove(const DynamicsRegion& region, std::optional<GroupIndex> joint, Span span,
             const Animation& animation) {
  if (region.moves_nothing() || Common(SpanOf(region), span).is_empty()) return false;
  const Figure& figure = *animation.figure;
  return region.root || (joint && IsBeyondAny(figure.group(*joint).last(), region, figure)) ||
         MayMoveRoot(region, animation);
}

}  // namespace hazumi
