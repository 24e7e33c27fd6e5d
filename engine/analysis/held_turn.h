#pragma once

// Regions in which keys hold the root's orientation while gravity and contacts move the figure.

#include <vector>

#include "engine/bake/motion.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Region whose root orientation stays keyed although the region leaves the rest of the body to
// gravity and the scene. The keys hold it by a residual moment, which neither ground nor pin
// supplies.
struct HeldTurn {
  size_t region = 0;    // index of Animation::regions
  int frame = 0;        // frame of the animation with the largest moment
  double moment = 0.0;  // residual moment in that frame [N m]
};

// Returns whether the region keeps the root's orientation keyed, touches the scene, and overlaps a
// placement by gravity. Such a region need not move the supporting links.
bool MayHoldTurn(const DynamicsRegion& region, const Animation& animation);
bool MayHoldTurns(const Animation& animation);

// Returns one entry for each such region that releases the body. A region releases the body if it
// moves the supporting links or, in flight, more than half of the mass. Moments below 2 % of the
// weight on an arm as long as the figure are omitted. The cost is that of the effort of the
// regions' frames (effort.h); the accelerations are the same as there.
std::vector<HeldTurn> FindHeldTurns(const Animation& animation, const Motion& motion);

// Returns one warning for each entry, with its place and the remedy.
std::vector<Warning> WarningsOf(const std::vector<HeldTurn>& turns, const Animation& animation);

}  // namespace hazumi
