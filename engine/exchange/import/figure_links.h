#pragma once

// Internal. What of a figure made from bones touches things.

#include <vector>

#include "engine/exchange/import/joint_plan.h"
#include "engine/figure/figure_spec.h"
#include "engine/figure/skin.h"

namespace hazumi {

// Capsules from each joint to those beyond it, by kept bone, in the bodies' frames [m], without
// masses. Thick as the skin is there; without one as such a part of a body is, or a stick.
std::vector<std::vector<LinkSpec>> LinksOf(const Character& character, const Skeleton& skeleton,
                                           const FigurePlan& plan, const Skin& skin,
                                           const WorldFrame& world);

}  // namespace hazumi
