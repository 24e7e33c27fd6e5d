#pragma once

#include "engine/exchange/scene/scene.h"
#include "engine/exchange/scene/scene_folder.h"

namespace hazumi {

// Materials that the character's meshes have, and their pictures: embedded, or in the scene's
// folder. Warns of pictures that are missing, lie elsewhere, or are neither PNG nor JPEG.
void ReadMaterials(const Scene& scene, SceneFolder* folder, Character* character);

}  // namespace hazumi
