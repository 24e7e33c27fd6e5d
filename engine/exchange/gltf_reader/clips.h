#pragma once

#include "engine/exchange/gltf_reader/accessors.h"
#include "engine/exchange/gltf_reader/nodes.h"

namespace hazumi {

// Adds animations as far as they move nodes of the scene, by channels or by pointers
// (KHR_animation_pointer) to a node's translation, rotation or scale. A channel without a node is
// left out, as glTF demands. Warns of what else is moved: shapes, materials. Errors: keys that
// cannot be read, or not as many values as times.
Result<Done> AddGltfClips(const GltfDocument& document, const GltfNodes& nodes,
                          const std::string& file, GltfAccessors* accessors, Scene* scene);

}  // namespace hazumi
