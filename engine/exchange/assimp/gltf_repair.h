#pragma once

#include "engine/exchange/assimp/gltf_document.h"
#include "engine/exchange/assimp/scene_files.h"

namespace hazumi {

// Writes correct glTF in a way that assimp 5.2.5 reads correctly: skin weights of 8 or 16 bits,
// whose bytes it takes for floats, as floats; with a default scene (gltf_scene.h); skins without
// matrices, at which it crashes, with identities; nodes with names of their own, by which it tells
// bones apart ("node_7" for those without any). Warns of renaming. Errors: such weights that cannot
// be read; skins whose matrices are none; no nodes.
Result<Done> RepairGltf(GltfDocument* document, SceneFiles* files, const std::string& file,
                        std::vector<Warning>* warnings);

}  // namespace hazumi
