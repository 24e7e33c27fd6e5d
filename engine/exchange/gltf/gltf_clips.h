#pragma once

// Internal. Clips as glTF animations.

#include "engine/exchange/character/character.h"
#include "engine/exchange/gltf/gltf_buffer.h"

namespace hazumi {

// The animation of a clip; the node of a bone has the bone's number. Null if nothing of it can be
// seen: no frames, or every bone as at rest throughout.
GltfJson GltfAnimation(const Character& character, const Clip& clip, GltfBuffer* buffer);

// [x, y, z, w], unit.
std::array<double, 4> GltfQuaternion(const Eigen::Quaterniond& q);

}  // namespace hazumi
