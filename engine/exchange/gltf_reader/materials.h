#pragma once

#include "engine/exchange/gltf_reader/accessors.h"
#include "engine/exchange/scene/scene.h"

namespace hazumi {

// Adds materials and their pictures, in the document's order.
void AddGltfMaterials(const GltfDocument& document, GltfAccessors* accessors, Scene* scene);

}  // namespace hazumi
