#pragma once

#include <vector>

#include "engine/exchange/character/axes.h"
#include "engine/figure/skin.h"

namespace hazumi {

// Gives the character the meshes, materials and textures of a figure's skin, in the axes and the
// unit of the file. `bones`: the character's bone for each of the skin's.
void PutSkinOn(const Skin& skin, const std::vector<int>& bones, const FileAxes& axes,
               Character* character);

}  // namespace hazumi
