// The root from its pin [Arai 3.1].

#include "engine/bake/pose/pinned_root.h"

#include "engine/placement/root_placement.h"

namespace hazumi {

PinnedRoot::PinnedRoot(const PlacementSpan& span, const RootPlacementSite& site)
    : figure_(site.figure), ws_(site.ws), pin_(*span.pin), joint_(figure_.group(*span.pin).first) {}

void PinnedRoot::Begin(double /*seconds*/, const FigureMotion& motion) {
  ComputePositions(figure_, motion.X_WR, motion.q, &ws_);
  state_.pin_W = ws_.body(joint_).p;
}

void PinnedRoot::Place(double /*frame*/, Side /*side*/, FigureMotion* motion) {
  PinRoot(figure_, joint_, state_.pin_W, &ws_, motion);
}

}  // namespace hazumi
