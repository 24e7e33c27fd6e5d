#pragma once

// Internal.

#include <vector>

#include "engine/exchange/import/joint_plan.h"
#include "engine/figure/figure_spec.h"
#include "engine/figure/skin.h"

namespace hazumi {

// How high [m] the ground is under a figure that stands on it: where the lowest point of its skin,
// or without one of its capsules, `links` by kept bone, comes in the clip, but for one frame in
// twenty. 0 if that is but a few centimetres off.
double GroundUnder(const FigurePlan& plan, const Skin& skin,
                   const std::vector<std::vector<LinkSpec>>& links);

}  // namespace hazumi
