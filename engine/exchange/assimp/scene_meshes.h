#pragma once

#include "engine/exchange/assimp/scene_skeleton.h"

namespace hazumi {

// All meshes: skinned ones with the four strongest bones of each vertex, others bound to the bone
// that they hang on. Warns of weights cut off and of vertices without any. Error: indices out of
// range.
Result<std::vector<SkinMesh>> ReadMeshes(const aiScene& scene, const SceneTree& tree,
                                         const SceneSkeleton& skeleton, const std::string& file,
                                         std::vector<Warning>* warnings);

}  // namespace hazumi
