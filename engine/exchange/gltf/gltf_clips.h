#pragma once

// Internal. Clips as glTF animations.

#include <vector>

#include "engine/exchange/character/character.h"
#include "engine/exchange/gltf/gltf_buffer.h"

namespace hazumi {

// A node, and how a clip moves it.
struct GltfMovedNode {
  size_t node = 0;
  Pose rest;
  Vec3 rest_scale = Vec3::Ones();
  const BoneTrack* track = nullptr;  // one entry a frame, or none, in each list
};

// The animation of a clip. Null if nothing of it can be seen: no frames, or every node as at rest
// throughout.
GltfJson GltfAnimation(const std::vector<GltfMovedNode>& nodes, const Clip& clip,
                       GltfBuffer* buffer);

// [x, y, z, w], unit.
std::array<double, 4> GltfQuaternion(const Eigen::Quaterniond& q);

}  // namespace hazumi
