#include "engine/exchange/assimp/gltf_repair.h"

#include <cstring>
#include <optional>
#include <set>
#include <vector>

#include "engine/base/base64.h"
#include "engine/exchange/assimp/gltf_scene.h"

namespace hazumi {
namespace {

using Json = nlohmann::json;
enum ComponentType : size_t { kUnsignedByte = 5121, kUnsignedShort = 5123, kFloat = 5126 };

// Numbers in a buffer of their own; returns the index of its view.
size_t AddView(const std::vector<float>& floats, Json* json) {
  const std::string_view bytes(reinterpret_cast<const char*>(floats.data()),
                               floats.size() * sizeof(float));
  Json& buffers = (*json)["buffers"];
  Json& views = (*json)["bufferViews"];
  buffers.push_back({{"byteLength", bytes.size()},
                     {"uri", "data:application/octet-stream;base64," + ToBase64(bytes)}});
  views.push_back({{"buffer", buffers.size() - 1}, {"byteLength", bytes.size()}});
  return views.size() - 1;
}

class WeightRepair {
 public:
  WeightRepair(GltfDocument* document, SceneFiles* files) : document_(*document), files_(*files) {}

  // False: an accessor cannot be read.
  bool Run() {
    for (const size_t index : IntegerWeights()) {
      const std::optional<std::vector<float>> weights = Floats(index);
      if (!weights) return false;
      PutBack(index, *weights);
    }
    return true;
  }

 private:
  const Json& json() const { return document_.json; }

  // Accessors of weights that are not floats.
  std::set<size_t> IntegerWeights() const {
    std::set<size_t> found;
    const Json& accessors = Member(json(), "accessors");
    for (const Json& mesh : Member(json(), "meshes")) {
      for (const Json& primitive : Member(mesh, "primitives")) {
        const Json& attributes = Member(primitive, "attributes");
        for (auto it = attributes.begin(); attributes.is_object() && it != attributes.end(); ++it) {
          if (it.key().starts_with("WEIGHTS_") && Element(accessors, it.value()).is_object() &&
              Count(Element(accessors, it.value()), "componentType", kFloat) != kFloat)
            found.insert(it.value().get<size_t>());
        }
      }
    }
    return found;
  }

  std::optional<std::string> Buffer(size_t index) const {
    const Json& buffer = Element(Member(json(), "buffers"), index);
    const Json& uri = Member(buffer, "uri");
    if (!uri.is_string()) return index == 0 ? std::optional(document_.binary) : std::nullopt;
    const std::string text = uri.get<std::string>();
    if (!text.starts_with("data:")) return files_.Contents(text);
    const size_t comma = text.find(";base64,");
    return comma == std::string::npos ? std::nullopt : FromBase64(text.substr(comma + 8));
  }

  // Four numbers an element, between 0 and 1.
  std::optional<std::vector<float>> Floats(size_t index) const {
    const Json& accessor = Element(Member(json(), "accessors"), index);
    const Json& view = Element(Member(json(), "bufferViews"), Member(accessor, "bufferView"));
    const size_t type = Count(accessor, "componentType", 0), count = Count(accessor, "count", 0);
    const size_t size = type == kUnsignedByte ? 1 : type == kUnsignedShort ? 2 : 0;
    const std::optional<std::string> bytes = Buffer(Count(view, "buffer", 0));
    if (size == 0 || !view.is_object() || !bytes || accessor.contains("sparse") ||
        Member(accessor, "type") != "VEC4")
      return std::nullopt;
    const size_t stride = Count(view, "byteStride", 4 * size);
    const size_t offset = Count(view, "byteOffset", 0) + Count(accessor, "byteOffset", 0);
    const size_t length = bytes->size();
    if (count == 0 || stride < 4 * size || stride > 252 || offset > length ||
        count > (length - offset) / (4 * size) || (count - 1) * stride + 4 * size > length - offset)
      return std::nullopt;
    std::vector<float> floats;
    for (size_t i = 0; i < count * 4; ++i) {
      const char* at = bytes->data() + offset + i / 4 * stride + i % 4 * size;
      uint16_t value = 0;  // little-endian, as this machine
      std::memcpy(&value, at, size);
      floats.push_back(static_cast<float>(value) / (size == 1 ? 255.0f : 65535.0f));
    }
    return floats;
  }

  void PutBack(size_t index, const std::vector<float>& floats) {
    const size_t view = AddView(floats, &document_.json);
    Json& accessor = document_.json["accessors"][index];
    accessor["bufferView"] = view;
    accessor["componentType"] = static_cast<size_t>(kFloat);
    for (const char* key : {"byteOffset", "normalized", "min", "max"}) accessor.erase(key);
  }

  GltfDocument& document_;
  SceneFiles& files_;
};

// Skins without matrices, which are then identities.
void AddBinds(Json* json) {
  if (!Member(*json, "skins").is_array()) return;
  for (Json& skin : (*json)["skins"]) {
    const Json& joints = Member(skin, "joints");
    if (!joints.is_array() || joints.empty() || skin.contains("inverseBindMatrices")) continue;
    std::vector<float> matrices(16 * joints.size(), 0.0f);
    for (size_t i = 0; i < matrices.size(); i += i % 16 == 15 ? 1 : 5) matrices[i] = 1.0f;
    Json& accessors = (*json)["accessors"];
    accessors.push_back({{"bufferView", AddView(matrices, json)},
                         {"componentType", static_cast<size_t>(kFloat)},
                         {"count", joints.size()},
                         {"type", "MAT4"}});
    skin["inverseBindMatrices"] = accessors.size() - 1;
  }
}

// First skin whose matrices are not a list of at least one 4x4 matrix of floats per joint. Assimp
// would read uninitialized memory for such a skin.
std::optional<size_t> SkinWithWrongBinds(const Json& json) {
  const Json& skins = Member(json, "skins");
  for (size_t i = 0; skins.is_array() && i < skins.size(); ++i) {
    const Json& accessor =
        Element(Member(json, "accessors"), Member(skins[i], "inverseBindMatrices"));
    const bool are_matrices = Member(accessor, "type") == "MAT4" &&
                              Count(accessor, "componentType", 0) == kFloat &&
                              accessor.contains("bufferView") && !accessor.contains("sparse") &&
                              Count(accessor, "count", 0) >= Member(skins[i], "joints").size();
    if (skins[i].contains("inverseBindMatrices") && !are_matrices) return i;
  }
  return std::nullopt;
}

void NameNodes(Json* document, std::vector<Warning>* warnings) {
  if (!Member(*document, "nodes").is_array()) return;
  std::set<std::string> names;
  size_t index = 0;
  for (Json& node : (*document)["nodes"]) {
    const std::string number = "_" + std::to_string(index++);
    if (!node.is_object()) continue;
    const Json& written = Member(node, "name");
    const std::string wanted = written.is_string() ? written.get<std::string>() : "";
    std::string name = wanted.empty() ? "node" + number : wanted;
    while (!names.insert(name).second) name += number;
    if (!wanted.empty() && name != wanted)
      warnings->push_back({"node " + wanted, "another node has this name; renamed to " + name});
    node["name"] = name;
  }
}

}  // namespace

Result<Done> RepairGltf(GltfDocument* document, SceneFiles* files, const std::string& file,
                        std::vector<Warning>* warnings) {
  NameNodes(&document->json, warnings);
  AddBinds(&document->json);
  if (const auto skin = SkinWithWrongBinds(document->json)) {
    return Error{
        ErrorCode::kSchema, file, "skins[" + std::to_string(*skin) + "]",
        "its inverse bind matrices are no list of one 4x4 matrix of 32-bit floats for each "
        "joint; export it again"};
  }
  if (Result<Done> chosen = ChooseScene(document, file, warnings); !chosen.ok()) return chosen;
  if (WeightRepair(document, files).Run()) return Done{};
  return Error{ErrorCode::kSchema, file, "meshes",
               "its skin weights are whole numbers that cannot be read; export them as 32-bit "
               "floats (in most exporters: without compression or quantization)"};
}

}  // namespace hazumi
