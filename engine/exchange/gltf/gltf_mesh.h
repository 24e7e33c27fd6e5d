#pragma once

// Internal. A mesh as glTF wants it.

#include "engine/exchange/character/character.h"
#include "engine/exchange/gltf/gltf_buffer.h"

namespace hazumi {

bool HasTriangles(const SkinMesh& mesh);

// A mesh of one primitive; joint i of its skin is bone i.
GltfJson GltfMesh(const SkinMesh& mesh, GltfBuffer* buffer);

}  // namespace hazumi
