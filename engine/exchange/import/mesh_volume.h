#pragma once

// Internal. How much of a mesh each bone moves.

#include <vector>

#include "engine/exchange/import/joint_plan.h"
#include "engine/figure/skin.h"

namespace hazumi {

// By kept bone [m^3], at rest: what its part of the skin encloses, cut off at the joints. They add
// up to the volume of the mesh; a part may be negative where surfaces cross. Nothing if the mesh
// encloses nothing: it has holes as large as itself, or there is none.
std::vector<double> MeshVolumes(const Skin& skin, const FigurePlan& plan);

}  // namespace hazumi
