#pragma once

#include "engine/exchange/gltf_reader/accessors.h"
#include "engine/exchange/gltf_reader/nodes.h"

namespace hazumi {

// Adds the meshes of the scene's nodes: a SceneMesh for each primitive with triangles, and again
// for each other skin. Where normals are missing they are the mean of the triangles' around a
// place, by area. Errors: accessors that cannot be read, indices out of range, skins without
// matrices.
Result<Done> AddGltfMeshes(const GltfDocument& document, const GltfNodes& nodes,
                           const std::string& file, GltfAccessors* accessors, Scene* scene);

}  // namespace hazumi
