#pragma once

// Internal.

#include "engine/exchange/import/joint_plan.h"
#include "engine/figure/skin.h"

namespace hazumi {

// The character's meshes, bound to the bodies of the figure that was planned: `bones` are its
// joints. Vertices stay as they are; the binds take them to metres.
Skin SkinFor(const Character& character, const Skeleton& skeleton, const FigurePlan& plan,
             const WorldFrame& world);

}  // namespace hazumi
