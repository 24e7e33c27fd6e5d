#pragma once

#include <assimp/scene.h>

#include <vector>

#include "engine/exchange/assimp/scene_files.h"
#include "engine/exchange/character/character.h"

namespace hazumi {

// Materials, in the scene's order, and the pictures they name: embedded, or beside the scene.
// Warns of pictures that are missing, lie elsewhere, or are neither PNG nor JPEG.
void ReadMaterials(const aiScene& scene, SceneFiles* files, Character* character);

}  // namespace hazumi
