#include <algorithm>

#include "engine/base/base64.h"
#include "engine/exchange/gltf_reader/gltf_scene.h"

namespace hazumi {
namespace {

using Json = nlohmann::json;

ScenePicture PictureOf(const Json& image, GltfAccessors* accessors) {
  ScenePicture picture;
  picture.name = Text(Member(image, "name"));
  const std::string uri = Text(Member(image, "uri"));
  if (uri.starts_with("data:")) {
    const size_t comma = uri.find(";base64,");
    picture.bytes.emplace();
    if (comma != std::string::npos) {
      if (auto bytes = FromBase64(std::string_view(uri).substr(comma + 8)))
        picture.bytes = std::move(bytes);
    }
  } else if (!uri.empty()) {
    picture.name = uri;
  } else {
    const Result<std::string_view> bytes = accessors->View(Member(image, "bufferView"));
    picture.bytes = bytes.ok() ? std::string(bytes.value()) : std::string();
  }
  return picture;
}

}  // namespace

void AddGltfMaterials(const GltfDocument& document, GltfAccessors* accessors, Scene* scene) {
  const Json& images = Member(document.json, "images");
  const Json& textures = Member(document.json, "textures");
  for (const Json& image : images) scene->pictures.push_back(PictureOf(image, accessors));
  for (const Json& from : Member(document.json, "materials")) {
    SceneMaterial material;
    material.name = Text(Member(from, "name"));
    material.base_color = {1.0f, 1.0f, 1.0f, 1.0f};
    const Json& surface = Member(from, "pbrMetallicRoughness");
    const std::vector<double> color = Numbers(Member(surface, "baseColorFactor"), 4);
    for (size_t k = 0; k < color.size(); ++k) material.base_color[k] = static_cast<float>(color[k]);
    const auto picture_of = [&](const Json& reference) {
      const Json& image = Member(Element(textures, Member(reference, "index")), "source");
      return Element(images, image).is_object() ? image.get<int>() : -1;
    };
    material.picture = picture_of(Member(surface, "baseColorTexture"));
    const std::vector<double> emission = Numbers(Member(from, "emissiveFactor"), 3);
    const Json& stronger = Member(
        Member(Member(from, "extensions"), "KHR_materials_emissive_strength"), "emissiveStrength");
    const double strength = stronger.is_number() ? stronger.get<double>() : 1.0;
    for (size_t k = 0; k < emission.size(); ++k) {
      material.emission[k] = static_cast<float>(strength * emission[k]);
    }
    const bool shines = std::any_of(material.emission.begin(), material.emission.end(),
                                    [](float part) { return part > 0.0f; });
    if (shines) material.emission_picture = picture_of(Member(from, "emissiveTexture"));
    scene->materials.push_back(std::move(material));
  }
}

}  // namespace hazumi
