#pragma once

#include "engine/bake/pose/root_placement.h"

namespace hazumi {

// A figure that falls and lands [Arai 3.2]: a joint is pinned while it touches something, else its
// CoM is on a parabola. One class a method, as the walk is.
class BallisticRoot : public RootPlacement {
 public:
  bool is_ballistic() const override { return true; }
  RootHold hold() const override {
    if (!pin()) return {RootCoupling::kFlight, JointIndex()};
    return {RootCoupling::kPinned, figure_.group(*pin()).first};
  }

 protected:
  explicit BallisticRoot(const RootPlacementSite& site) : figure_(site.figure), ws_(site.ws) {}

  const Figure& figure_;
  DynamicsWorkspace& ws_;
};

// By the paper's steps: contact is looked for at the end of each.
class PaperBallisticRoot : public BallisticRoot {
 public:
  PaperBallisticRoot(const PlacementSpan& span, const RootPlacementSite& site);

  void Begin(double /*seconds*/, const FigureMotion& motion) override {
    gravity_.Start(motion, &ws_);
  }
  void Resume(const RootPlacementState& state) override {
    gravity_.Resume(std::get<GravityPlacement::State>(state));
  }
  RootPlacementState state() const override { return gravity_.state(); }
  void RenewFlight(double /*seconds*/, const FigureMotion& motion) override {
    gravity_.RenewFlight(motion, &ws_);
  }

  std::optional<GroupIndex> pin() const override { return gravity_.pin(); }
  // At the end of the last step.
  void Place(double /*frame*/, Side /*side*/, FigureMotion* motion) override {
    gravity_.Place(&ws_, motion);
  }
  std::vector<RootEvent> Step(const FigureMotion& from, double seconds, Side side,
                              FigureMotion* to) override;
  bool has_landed() const override { return gravity_.has_landed(); }
  bool PlaceWithinStep(double seconds_before_end, FigureMotion* motion) override;

 private:
  GravityPlacement gravity_;
};

// In continuous time: take-off and landing at the instants where they happen.
class ExactBallisticRoot : public BallisticRoot {
 public:
  ExactBallisticRoot(const PlacementSpan& span, const RootPlacementSite& site);

  void Begin(double seconds, const FigureMotion& motion) override {
    gravity_.Start(seconds, motion, &ws_);
  }
  void Resume(const RootPlacementState& state) override {
    gravity_.Resume(std::get<ContinuousGravity::State>(state));
  }
  RootPlacementState state() const override { return gravity_.state(); }
  void RenewFlight(double seconds, const FigureMotion& motion) override {
    gravity_.RenewFlight(seconds, motion, &ws_);
  }
  void LeaveToContacts(double seconds, const FigureMotion& motion) override {
    gravity_.LeaveToContacts(seconds, motion, &ws_);
  }
  void TakeBack(double seconds, const FigureMotion& motion) override {
    gravity_.TakeBack(seconds, motion, &ws_);
  }

  std::optional<GroupIndex> pin() const override { return gravity_.pin(); }
  void Place(double frame, Side /*side*/, FigureMotion* motion) override {
    gravity_.Place(rate_.SecondsAt(frame), &ws_, motion);
  }
  std::optional<GravityEvent> FirstEvent(double t0, double t1,
                                         const ContinuousGravity::Pose& pose) override {
    return gravity_.FirstEvent(t0, t1, pose, &ws_);
  }
  RootEvent Happen(const GravityEvent& event, const FigureMotion& motion) override;

 private:
  FrameRate rate_;
  ContinuousGravity gravity_;
};

}  // namespace hazumi
