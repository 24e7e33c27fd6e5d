#pragma once

// Internal. Materials, and the pictures they show.

#include <map>
#include <optional>
#include <utility>

#include "engine/exchange/character/character.h"
#include "engine/exchange/gltf/gltf_buffer.h"

namespace hazumi {

// Writes those that are asked for, each once.
class GltfMaterials {
 public:
  GltfMaterials(const Character& character, GltfBuffer* buffer)
      : character_(character), buffer_(buffer) {}

  // The number of the material; of a mesh that has no texture coordinates, without its textures.
  int Number(int material, bool with_texture);

  const GltfJson& materials() const { return materials_; }
  const GltfJson& textures() const { return textures_; }
  const GltfJson& images() const { return images_; }
  // Whether one shines brighter than glTF alone can say: KHR_materials_emissive_strength is used.
  bool has_bright() const { return has_bright_; }
  // A texture that is no PNG or JPEG file, by its number.
  std::optional<int> unknown_texture() const { return unknown_texture_; }

 private:
  int TextureNumber(int texture);
  void AddEmission(const Material& from, float strength, bool with_texture, GltfJson* written);

  const Character& character_;
  GltfBuffer* buffer_;
  GltfJson materials_ = GltfJson::array(), textures_ = GltfJson::array(),
           images_ = GltfJson::array();
  std::map<std::pair<int, bool>, int> material_numbers_;
  std::map<int, int> texture_numbers_;
  std::optional<int> unknown_texture_;
  bool has_bright_ = false;
};

}  // namespace hazumi
