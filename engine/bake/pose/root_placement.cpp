// Keyed and pinned roots [Arai 3.1]. Only this file knows which kinds of placement there are.

#include "engine/bake/pose/root_placement.h"

#include "engine/bake/pose/ballistic_root.h"
#include "engine/placement/figure_motion.h"

namespace hazumi {

namespace {

// The root is where its curves have it.
class KeyedRoot : public RootPlacement {
 public:
  explicit KeyedRoot(const RootPlacementSite& site) : curves_(site.curves) {}

  bool is_keyed() const override { return true; }
  RootHold hold() const override { return {}; }
  void Place(double frame, Side side, FigureMotion* motion) override {
    curves_.SampleRootPosition(frame, side, motion);
  }

 private:
  CurveSet& curves_;
};

// The root is where a joint has to be that keeps its place [Arai 3.1], that which it has at the
// beginning.
class PinnedRoot : public RootPlacement {
 public:
  PinnedRoot(const PlacementSpan& span, const RootPlacementSite& site);

  void Begin(double seconds, const FigureMotion& motion) override;
  void Resume(const RootPlacementState& state) override { state_ = std::get<PinState>(state); }
  RootPlacementState state() const override { return state_; }

  RootHold hold() const override { return {RootCoupling::kPinned, joint_}; }
  std::optional<GroupIndex> pin() const override { return pin_; }
  void Place(double frame, Side side, FigureMotion* motion) override;

 private:
  const Figure& figure_;
  DynamicsWorkspace& ws_;
  GroupIndex pin_;
  JointIndex joint_;  // its first hinge
  PinState state_;
};

PinnedRoot::PinnedRoot(const PlacementSpan& span, const RootPlacementSite& site)
    : figure_(site.figure), ws_(site.ws), pin_(*span.pin), joint_(figure_.group(*span.pin).first) {}

void PinnedRoot::Begin(double /*seconds*/, const FigureMotion& motion) {
  ComputePositions(figure_, motion.X_WR, motion.q, &ws_);
  state_.pin_W = ws_.body(joint_).p;
}

void PinnedRoot::Place(double /*frame*/, Side /*side*/, FigureMotion* motion) {
  PinRoot(figure_, joint_, state_.pin_W, &ws_, motion);
}

}  // namespace

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
