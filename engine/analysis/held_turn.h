#pragma once

// Regions in which gravity and contacts move the figure while keys hold its root's turn.

#include <vector>

#include "engine/bake/motion.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// The root's turn stays with its keys, although a region leaves the rest of the body to gravity and
// the scene: what holds the turn is a moment that neither ground nor pin supplies.
struct HeldTurn {
  size_t region = 0;    // index of Animation::regions
  int frame = 0;        // of the animation, where the moment is largest
  double moment = 0.0;  // there [N m]
};

// Whether the region leaves the root's turn to its keys where gravity places the figure, and
// touches the scene. Such a region may or may not move what the figure stands on.
bool MayHoldTurn(const DynamicsRegion& region, const Animation& animation);
bool MayHoldTurns(const Animation& animation);

// One entry for each such region that lets the body go: in its frames it moves what the figure
// stands on or, where the figure is in the air, more than half of its mass. Moments below 2 % of
// the weight on an arm as long as the figure are left out. Costs as much as the effort of the
// regions' frames (effort.h); accelerations are taken as there.
std::vector<HeldTurn> FindHeldTurns(const Animation& animation, const Motion& motion);

// The same in words, with the place and the remedy.
std::vector<Warning> WarningsOf(const std::vector<HeldTurn>& turns, const Animation& animation);

}  // namespace hazumi
