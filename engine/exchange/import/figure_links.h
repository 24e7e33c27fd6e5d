#pragma once

// Internal. What a figure made from bones weighs and what of it touches things.

#include <vector>

#include "engine/exchange/import/joint_plan.h"
#include "engine/figure/figure_spec.h"
#include "engine/figure/skin.h"

namespace hazumi {

// Capsules from each joint to those beyond it, by kept bone, in the bodies' frames [m]. Thick as
// the skin is there; without one as such a part of a body is, or a stick. Masses are those of a
// person's parts where the bones say what they are, shared out by volume; others weigh as water
// does; `mass` [kg] is that of all.
std::vector<std::vector<LinkSpec>> LinksOf(const Character& character, const Skeleton& skeleton,
                                           const FigurePlan& plan, const Skin& skin,
                                           const WorldFrame& world, double mass);

}  // namespace hazumi
