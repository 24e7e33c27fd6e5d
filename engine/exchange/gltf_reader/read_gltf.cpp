#include "engine/exchange/gltf_reader/read_gltf.h"

#include <algorithm>

#include "engine/base/utf8.h"
#include "engine/exchange/gltf_reader/gltf_scene.h"

namespace hazumi {
namespace {

using Json = nlohmann::json;

// Whether a file that requires an extension can be read: what it changes is read, or only changes
// what surfaces look like.
bool IsKnown(const std::string& extension) {
  constexpr std::string_view kRead[] = {"KHR_mesh_quantization", "KHR_animation_pointer",
                                        "KHR_draco_mesh_compression", "EXT_meshopt_compression"};
  constexpr std::string_view kLooks[] = {"KHR_materials_", "KHR_texture_", "EXT_texture_",
                                         "KHR_lights_"};
  return std::find(std::begin(kRead), std::end(kRead), extension) != std::end(kRead) ||
         std::any_of(std::begin(kLooks), std::end(kLooks), [&](std::string_view beginning) {
           return std::string_view(extension).starts_with(beginning);
         });
}

Result<Done> CheckExtensions(const Json& json, const std::string& file) {
  for (const Json& required : Member(json, "extensionsRequired")) {
    const std::string name = Text(required);
    if (IsKnown(name)) continue;
    return Error{
        ErrorCode::kSemantics, file, "extensionsRequired",
        "requires " + ValidUtf8(name) + ", which Hazumi does not read; export the file without it"};
  }
  return Done{};
}

}  // namespace

Result<Scene> ReadGltf(std::string_view bytes, const std::string& file, SceneFolder* folder) {
  const Result<GltfDocument> document = ParseGltf(bytes, file);
  if (!document.ok()) return document.error();
  if (Result<Done> known = CheckExtensions(document.value().json, file); !known.ok())
    return known.error();
  Scene scene;
  scene.up = UpAxis::kY;
  scene.metres_per_unit = 1.0;
  const Result<GltfNodes> nodes = AddGltfNodes(document.value(), file, &scene);
  if (!nodes.ok()) return nodes.error();
  AddVrmPlaces(document.value(), nodes.value(), &scene);
  WarnOfNotRead(document.value(), &scene);
  GltfAccessors accessors(document.value(), folder, file);
  AddGltfMaterials(document.value(), &accessors, &scene);
  for (const auto add : {AddGltfMeshes, AddGltfClips}) {
    if (Result<Done> added = add(document.value(), nodes.value(), file, &accessors, &scene);
        !added.ok())
      return added.error();
  }
  return scene;
}

}  // namespace hazumi
