// The one place that knows which kinds of placement there are.

#include "engine/bake/pose/root_placement.h"

#include "engine/bake/pose/ballistic_root.h"
#include "engine/bake/pose/keyed_root.h"
#include "engine/bake/pose/pinned_root.h"

namespace hazumi {

std::unique_ptr<RootPlacement> MakeRootPlacement(const PlacementSpan* span,
                                                 const RootPlacementSite& site) {
  if (span && span->kind == PlacementKind::kPinned) {
    return std::make_unique<PinnedRoot>(*span, site);
  }
  if (!span || span->kind == PlacementKind::kKeyed) return std::make_unique<KeyedRoot>(site);
  if (site.animation.solver.method == Method::kExact) {
    return std::make_unique<ExactBallisticRoot>(*span, site);
  }
  return std::make_unique<PaperBallisticRoot>(*span, site);
}

}  // namespace hazumi
