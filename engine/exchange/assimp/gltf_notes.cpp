#include "engine/exchange/assimp/gltf_notes.h"

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>

namespace hazumi {
namespace {

using Json = nlohmann::json;

Error Wrong(ErrorCode code, const std::string& file, const std::string& place,
            const std::string& message) {
  return {code, file, place, message};
}

// The JSON of a GLB: its first chunk.
std::string_view JsonText(std::string_view bytes) {
  if (!bytes.starts_with("glTF")) return bytes;
  uint32_t length = 0;
  if (bytes.size() < 20) return {};
  std::memcpy(&length, bytes.data() + 12, sizeof length);
  return bytes.substr(20, length);
}

// Elements and members that may be missing or of another type: then null.
const Json& Member(const Json& value, const std::string& key) {
  static const Json kNull;
  const auto found = value.is_object() ? value.find(key) : value.end();
  return value.is_object() && found != value.end() ? *found : kNull;
}
const Json& Element(const Json& list, const Json& index) {
  static const Json kNull;
  if (!list.is_array() || !index.is_number_unsigned() || index.get<uint64_t>() >= list.size())
    return kNull;
  return list[index.get<size_t>()];
}

std::string Text(const Json& value) { return value.is_string() ? value.get<std::string>() : ""; }

// The name that assimp gives to a node.
std::string NodeName(const Json& document, const Json& index) {
  const std::string name = Text(Member(Element(Member(document, "nodes"), index), "name"));
  return name.empty() && index.is_number_unsigned()
             ? "nodes[" + std::to_string(index.get<size_t>()) + "]"
             : name;
}

void NoteChannels(const Json& document, GltfNotes* notes) {
  const Json& animations = Member(document, "animations");
  for (size_t a = 0; animations.is_array() && a < animations.size(); ++a)
    for (const Json& channel : Member(animations[a], "channels")) {
      const Json& sampler = Element(Member(animations[a], "samplers"), Member(channel, "sampler"));
      const std::string interpolation = Text(Member(sampler, "interpolation"));
      const Json& target = Member(channel, "target");
      if (interpolation == "CUBICSPLINE") ++notes->num_splines;
      if (interpolation == "STEP")
        notes->stepped.insert(std::to_string(a) + "/" + NodeName(document, Member(target, "node")) +
                              "/" + Text(Member(target, "path")));
    }
}

// Whether weights are written as floats: assimp takes the bytes of others for floats.
bool HasIntegerWeights(const Json& document) {
  constexpr int kFloat = 5126;
  for (const Json& mesh : Member(document, "meshes"))
    for (const Json& primitive : Member(mesh, "primitives"))
      for (const auto& [name, accessor] : Member(primitive, "attributes").items())
        if (name.starts_with("WEIGHTS_") &&
            Member(Element(Member(document, "accessors"), accessor), "componentType") != kFloat)
          return true;
  return false;
}

}  // namespace

Result<GltfNotes> InspectGltf(std::string_view bytes, const std::string& file) {
  std::string_view text = JsonText(bytes);
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const Json document = Json::parse(text, nullptr, false);
  if (!document.is_object())
    return Wrong(ErrorCode::kSyntax, file, "", "its JSON is broken; export the file again");
  const std::string version = Text(Member(Member(document, "asset"), "version"));
  if (!version.starts_with("2."))
    return Wrong(ErrorCode::kSchema, file, "asset.version",
                 (version.empty() ? "is missing" : "is " + version) +
                     ", but Hazumi reads glTF 2.0; export the file as glTF 2.0");
  if (HasIntegerWeights(document))
    return Wrong(ErrorCode::kSchema, file, "meshes",
                 "skin weights are written as integers, which cannot be read yet; export them as "
                 "32-bit floats (in most exporters: without compression or quantization)");
  GltfNotes notes;
  NoteChannels(document, &notes);
  return notes;
}

}  // namespace hazumi
