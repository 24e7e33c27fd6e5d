#pragma once

#include "engine/bake/pose/root_placement.h"

namespace hazumi {

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

}  // namespace hazumi
