#include <algorithm>

#include "engine/exchange/gltf_reader/gltf_scene.h"

namespace hazumi {
namespace {

using Json = nlohmann::json;

class Finder {
 public:
  explicit Finder(const Json& json) : json_(json) {}

  std::vector<std::string> Find() {
    LookAtMeshes();
    LookAtMaterials();
    LookAtAvatar();
    return std::move(found_);
  }

 private:
  void Add(bool is_there, const std::string& what) {
    if (is_there) found_.push_back(what);
  }

  void LookAtMeshes() {
    size_t shapes = 0;
    for (const Json& mesh : Member(json_, "meshes")) {
      size_t most = 0;
      for (const Json& primitive : Member(mesh, "primitives")) {
        const Json& targets = Member(primitive, "targets");
        if (targets.is_array()) most = std::max(most, targets.size());
      }
      shapes += most;
    }
    Add(shapes == 1, "1 shape (morph target)");
    Add(shapes > 1, std::to_string(shapes) + " shapes (morph targets)");
  }

  void LookAtMaterials() {
    bool normals = false, metal = false;
    for (const Json& material : Member(json_, "materials")) {
      normals |= !Member(material, "normalTexture").is_null();
      metal |=
          !Member(Member(material, "pbrMetallicRoughness"), "metallicRoughnessTexture").is_null();
    }
    Add(normals, "normal maps");
    Add(metal, "metal and roughness maps");
  }

  void LookAtAvatar() {
    const Json& extensions = Member(json_, "extensions");
    const bool is_avatar =
        !Member(extensions, "VRM").is_null() || !Member(extensions, "VRMC_vrm").is_null();
    Add(is_avatar, "VRM's expressions, look-at and springs");
  }

  const Json& json_;
  std::vector<std::string> found_;
};

}  // namespace

void WarnOfNotRead(const GltfDocument& document, Scene* scene) {
  std::string text;
  for (const std::string& part : Finder(document.json).Find())
    text += (text.empty() ? "" : ", ") + part;
  if (text.empty()) return;
  scene->warnings.push_back({"file", "not read: " + text +
                                         "; all of it stays where motion is put back into the "
                                         "file (--onto)"});
}

}  // namespace hazumi
