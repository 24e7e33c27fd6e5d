#pragma once

// Internal. What the links of a figure made from bones weigh.

#include <string>
#include <vector>

#include "engine/exchange/import/joint_plan.h"
#include "engine/figure/figure_spec.h"
#include "engine/figure/skin.h"

namespace hazumi {

// Gives the links, by kept bone, masses [kg] that are `mass` together. Where the bones are those of
// a body (body_names.h) each segment of the table weighs what the table says, whatever bones it
// consists of, and its links share that by volume; segments that no bone stands for are left out,
// and all others are heavier by the same factor. Else a bone weighs by the volume of the mesh that
// it moves, or without one by that of its links. Says which, in words that follow the mass.
std::string Weigh(const Skeleton& skeleton, const FigurePlan& plan, const Skin& skin, double mass,
                  std::vector<std::vector<LinkSpec>>* links);

}  // namespace hazumi
