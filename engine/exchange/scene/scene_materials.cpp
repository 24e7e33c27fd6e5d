#include <algorithm>
#include <cmath>
#include <string_view>

#include "engine/base/utf8.h"
#include "engine/exchange/scene/character_parts.h"

namespace hazumi {
namespace {

constexpr size_t kLongestPicture = 64u << 20;
constexpr float kBrightest = 1e3f;  // of emission

bool IsPicture(const std::vector<uint8_t>& bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return text.starts_with("\x89PNG\r\n\x1a\n") || text.starts_with("\xff\xd8\xff");
}

class MaterialReader {
 public:
  MaterialReader(const Scene& scene, SceneFolder* folder, Character* character)
      : scene_(scene),
        folder_(folder),
        character_(character),
        material_(scene.materials.size(), kUnread),
        texture_(scene.pictures.size(), kUnread) {}

  // Index among the character's.
  int Material(int index) {
    int& made = material_[static_cast<size_t>(index)];
    if (made == kUnread) made = AddMaterial(scene_.materials[static_cast<size_t>(index)]);
    return made;
  }

 private:
  static constexpr int kUnread = -2;

  int AddMaterial(const SceneMaterial& from) {
    hazumi::Material material;
    material.name = ValidUtf8(from.name);
    for (size_t k = 0; k < 4; ++k) {
      const float part = from.base_color[k];
      material.base_color[k] = std::isfinite(part) ? std::min(std::max(part, 0.0f), 1.0f) : 1.0f;
    }
    const std::string place = "material " + material.name;
    if (from.picture >= 0) material.texture = TextureOf(from.picture, place);
    if (from.emission_picture >= 0) {
      material.emission_texture = TextureOf(from.emission_picture, place);
    }
    for (size_t k = 0; k < 3; ++k) {
      const float part = from.emission[k];
      material.emission[k] = std::isfinite(part) ? std::clamp(part, 0.0f, kBrightest) : 0.0f;
    }
    character_->materials.push_back(std::move(material));
    return static_cast<int>(character_->materials.size()) - 1;
  }

  int TextureOf(int picture, const std::string& place) {
    int& made = texture_[static_cast<size_t>(picture)];
    if (made == kUnread) made = AddTexture(scene_.pictures[static_cast<size_t>(picture)], place);
    return made;
  }

  int AddTexture(const ScenePicture& picture, const std::string& place) {
    Texture texture;
    texture.name = ValidUtf8(picture.name);
    const std::optional<std::string> bytes =
        picture.bytes ? picture.bytes : folder_->Contents(picture.name);
    if (!bytes) {
      Warn(place, "its picture " + texture.name +
                      " is not in the file's folder or below it, so it is drawn in a flat colour; "
                      "put the picture beside the file");
      return -1;
    }
    if (bytes->size() <= kLongestPicture) texture.encoded.assign(bytes->begin(), bytes->end());
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

  const Scene& scene_;
  SceneFolder* folder_;
  Character* character_;
  std::vector<int> material_, texture_;  // index among the character's, by that of the scene
};

}  // namespace

void ReadMaterials(const Scene& scene, SceneFolder* folder, Character* character) {
  MaterialReader reader(scene, folder, character);
  for (SkinMesh& mesh : character->meshes) {
    if (mesh.material >= 0) mesh.material = reader.Material(mesh.material);
  }
}

}  // namespace hazumi
