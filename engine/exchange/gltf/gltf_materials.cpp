#include "engine/exchange/gltf/gltf_materials.h"

#include <algorithm>

namespace hazumi {

namespace {

constexpr double kRoughness = 0.8;

// Null: neither of the formats that glTF has.
const char* MimeTypeOf(std::string_view bytes) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return "image/png";
  if (bytes.starts_with("\xff\xd8\xff")) return "image/jpeg";
  return nullptr;
}

}  // namespace

int GltfMaterials::Number(int material, bool with_texture) {
  const Material& from = character_.materials[static_cast<size_t>(material)];
  with_texture = with_texture && (from.texture >= 0 || from.emission_texture >= 0);
  const auto [entry, is_new] =
      material_numbers_.try_emplace({material, with_texture}, static_cast<int>(materials_.size()));
  if (!is_new) return entry->second;
  GltfJson color = GltfJson::array();
  for (const float x : from.base_color) color.push_back(std::clamp(x, 0.0f, 1.0f));
  GltfJson surface = {
      {"baseColorFactor", color}, {"metallicFactor", 0.0}, {"roughnessFactor", kRoughness}};
  if (with_texture && from.texture >= 0) {
    surface["baseColorTexture"] = {{"index", TextureNumber(from.texture)}};
  }
  GltfJson written = {{"name", from.name}, {"pbrMetallicRoughness", surface}};
  const float brightest = *std::max_element(from.emission.begin(), from.emission.end());
  if (brightest > 0.0f) AddEmission(from, std::max(brightest, 1.0f), with_texture, &written);
  if (from.base_color[3] < 1.0f) written["alphaMode"] = "BLEND";
  materials_.push_back(std::move(written));
  return entry->second;
}

// A factor is at most 1; what is brighter takes an extension.
void GltfMaterials::AddEmission(const Material& from, float strength, bool with_texture,
                                GltfJson* written) {
  GltfJson color = GltfJson::array();
  for (const float x : from.emission) color.push_back(x / strength);
  (*written)["emissiveFactor"] = std::move(color);
  if (with_texture && from.emission_texture >= 0) {
    (*written)["emissiveTexture"] = {{"index", TextureNumber(from.emission_texture)}};
  }
  if (strength == 1.0f) return;
  (*written)["extensions"] = {
      {"KHR_materials_emissive_strength", {{"emissiveStrength", strength}}}};
  has_bright_ = true;
}

int GltfMaterials::TextureNumber(int texture) {
  const auto [entry, is_new] =
      texture_numbers_.try_emplace(texture, static_cast<int>(textures_.size()));
  if (!is_new) return entry->second;
  const Texture& from = character_.textures[static_cast<size_t>(texture)];
  const std::string_view bytes(reinterpret_cast<const char*>(from.encoded.data()),
                               from.encoded.size());
  const char* mime_type = MimeTypeOf(bytes);
  if (!mime_type) unknown_texture_ = texture;
  images_.push_back({{"name", from.name},
                     {"bufferView", buffer_->AddView(bytes, GltfUse::kPlain)},
                     {"mimeType", mime_type ? mime_type : ""}});
  textures_.push_back({{"source", entry->second}});
  return entry->second;
}

}  // namespace hazumi
