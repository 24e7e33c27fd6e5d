#pragma once

#include "engine/exchange/assimp/gltf_document.h"
#include "engine/exchange/assimp/scene_files.h"

namespace hazumi {

// Rewrites correct glTF so that assimp 5.2.5 reads it correctly. Skin weights of 8 or 16 bits
// become floats, since assimp misreads their bytes as floats. Adds a default scene (gltf_scene.h),
// identity matrices to skins without matrices, on which assimp crashes, and unique node names, by
// which assimp identifies bones ("node_7" for an unnamed node). Warns of renaming. Errors:
// unreadable weights; skins with invalid matrices; no nodes.
Result<Done> RepairGltf(GltfDocument* document, SceneFiles* files, const std::string& file,
                        std::vector<Warning>* warnings);

}  // namespace hazumi
