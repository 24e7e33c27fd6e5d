#pragma once

#include "engine/bake/bake_context.h"

namespace hazumi {

// At the frames where placements begin and end: who says where the root is [METHOD 5.8].
class PlacementHandover {
 public:
  explicit PlacementHandover(BakeContext* context) : context_(*context) {}

  // Ends the placement that ends at the frame, or begins the one that begins there; true if there
  // is one. `was_keyed`: the root was where its curves had it up to there.
  bool End(int frame);
  bool Begin(int frame, bool was_keyed);
  // After the figure was placed anew.
  void WarnOfVelocityJump(int frame);

 private:
  void TakeKeyedVelocity(int frame);
  void WarnOfDistance(int frame);

  BakeContext& context_;
};

}  // namespace hazumi
