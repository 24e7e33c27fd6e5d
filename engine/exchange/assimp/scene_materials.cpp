#include "engine/exchange/assimp/scene_materials.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>

#include <cmath>
#include <map>
#include <optional>

#include "engine/base/utf8.h"

namespace hazumi {
namespace {

constexpr size_t kLongestPicture = 64u << 20;

bool IsPicture(const std::vector<uint8_t>& bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return text.starts_with("\x89PNG\r\n\x1a\n") || text.starts_with("\xff\xd8\xff");
}

class MaterialReader {
 public:
  MaterialReader(const aiScene& scene, SceneFiles* files, Character* character)
      : scene_(scene), files_(files), character_(character) {}

  Material Read(const aiMaterial& from) {
    Material material;
    aiString name;
    if (from.Get(AI_MATKEY_NAME, name) == AI_SUCCESS) material.name = ValidUtf8(name.C_Str());
    aiColor4D color;
    if (from.Get(AI_MATKEY_BASE_COLOR, color) == AI_SUCCESS ||
        from.Get(AI_MATKEY_COLOR_DIFFUSE, color) == AI_SUCCESS)
      material.base_color = {color.r, color.g, color.b, color.a};
    for (float& part : material.base_color)
      part = std::isfinite(part) ? std::min(std::max(part, 0.0f), 1.0f) : 1.0f;
    aiString path;
    if (from.GetTexture(aiTextureType_BASE_COLOR, 0, &path) == AI_SUCCESS ||
        from.GetTexture(aiTextureType_DIFFUSE, 0, &path) == AI_SUCCESS)
      material.texture = TextureOf(path.C_Str(), material.name);
    return material;
  }

 private:
  int TextureOf(const std::string& path, const std::string& material) {
    const auto known = known_.find(path);
    if (known != known_.end()) return known->second;
    return known_[path] = AddTexture(path, "material " + material);
  }

  int AddTexture(const std::string& path, const std::string& place) {
    Texture texture;
    texture.name = ValidUtf8(path);
    if (const aiTexture* embedded = scene_.GetEmbeddedTexture(path.c_str())) {
      // Height 0: as a file, of "width" bytes.
      if (embedded->mHeight == 0 && embedded->mWidth <= kLongestPicture) {
        const auto* data = reinterpret_cast<const uint8_t*>(embedded->pcData);
        texture.encoded.assign(data, data + embedded->mWidth);
      }
      if (embedded->mFilename.length > 0) texture.name = ValidUtf8(embedded->mFilename.C_Str());
    } else if (const std::optional<std::string> bytes = files_->Contents(path)) {
      if (bytes->size() <= kLongestPicture) texture.encoded.assign(bytes->begin(), bytes->end());
    } else {
      Warn(place, "its picture " + texture.name +
                      " is not in the file's folder or below it, so it is drawn in a flat colour; "
                      "put the picture beside the file");
      return -1;
    }
    if (!IsPicture(texture.encoded)) {
      Warn(place, "its picture " + texture.name +
                      " is neither PNG nor JPEG, so it is drawn in a flat colour");
      return -1;
    }
    character_->textures.push_back(std::move(texture));
    return static_cast<int>(character_->textures.size()) - 1;
  }

  void Warn(const std::string& place, const std::string& message) {
    character_->warnings.push_back({place, message});
  }

  const aiScene& scene_;
  SceneFiles* files_;
  Character* character_;
  std::map<std::string, int> known_;  // textures by path
};

}  // namespace

void ReadMaterials(const aiScene& scene, SceneFiles* files, Character* character) {
  MaterialReader reader(scene, files, character);
  for (unsigned i = 0; i < scene.mNumMaterials; ++i)
    character->materials.push_back(reader.Read(*scene.mMaterials[i]));
}

}  // namespace hazumi
