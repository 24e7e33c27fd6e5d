#pragma once

#include "engine/bake/pose/root_placement.h"

namespace hazumi {

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

}  // namespace hazumi
