#pragma once

// Internal. Meshes of a glTF file, and the joints that they are bound to.

#include <optional>
#include <vector>

#include "engine/exchange/character/character.h"
#include "engine/exchange/gltf/gltf_buffer.h"

namespace hazumi {

// All bones are joints of every skin, joint i is bone i: so others see one skeleton. Meshes share a
// skin as long as none binds a bone otherwise than another.
class GltfSkins {
 public:
  explicit GltfSkins(const std::vector<Bone>& bones);

  // The number of the skin that the mesh has; none if it is bound twice to one bone, each time
  // otherwise.
  std::optional<int> Bind(const SkinMesh& mesh);
  // Bones that no mesh of a skin is bound to are bound as they rest.
  GltfJson Write(int skeleton, GltfBuffer* buffer) const;

 private:
  using Binding = std::vector<std::optional<Eigen::Matrix4d>>;  // by bone

  std::vector<Eigen::Matrix4d> rest_;  // inverse of each bone's rest pose in the file's world
  std::vector<Binding> skins_;
};

bool HasTriangles(const SkinMesh& mesh);

// A mesh of one primitive; joint i of its skin is bone i.
GltfJson GltfMesh(const SkinMesh& mesh, GltfBuffer* buffer);

}  // namespace hazumi
