#pragma once

#include "engine/exchange/scene/scene_skeleton.h"

namespace hazumi {

// All meshes: skinned ones with the four strongest bones of each vertex, others bound to the bone
// that they hang on. Warns of weights cut off and of vertices without any.
std::vector<SkinMesh> ReadMeshes(const SceneTree& tree, const SceneSkeleton& skeleton,
                                 std::vector<Warning>* warnings);

}  // namespace hazumi
