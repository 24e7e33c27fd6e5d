#pragma once

// Internal.

#include <vector>

#include "engine/exchange/import/joint_plan.h"
#include "engine/figure/figure_spec.h"

namespace hazumi {

// How high [m] the ground is under a figure that stands on it: where the lowest of its capsules,
// `links` by kept bone, comes in the clip, but for one frame in twenty. 0 if that is but a few
// centimetres off.
double GroundUnder(const FigurePlan& plan, const std::vector<std::vector<LinkSpec>>& links);

}  // namespace hazumi
