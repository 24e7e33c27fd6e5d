#include "engine/exchange/assimp/gltf_document.h"

#include <cmath>
#include <cstdint>
#include <cstring>

#include "engine/exchange/gltf/gltf_bodies.h"

namespace hazumi {
namespace {

using Json = nlohmann::json;
constexpr uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr size_t kHeader = 12, kChunkHeader = 8;

uint32_t NumberAt(std::string_view bytes, size_t offset) {
  uint32_t number = 0;
  if (offset + sizeof number <= bytes.size())
    std::memcpy(&number, bytes.data() + offset, sizeof number);
  return number;
}

// The first chunk of a kind; empty: none.
std::string_view Chunk(std::string_view glb, uint32_t kind) {
  for (size_t at = kHeader; at + kChunkHeader <= glb.size();) {
    const size_t length = NumberAt(glb, at);
    if (NumberAt(glb, at + 4) == kind) return glb.substr(at + kChunkHeader, length);
    at += kChunkHeader + length;
  }
  return {};
}

void Append(uint32_t number, std::string* bytes) {
  bytes->append(reinterpret_cast<const char*>(&number), sizeof number);
}

void AppendChunk(uint32_t kind, std::string content, char filler, std::string* bytes) {
  content.resize((content.size() + 3) / 4 * 4, filler);
  Append(static_cast<uint32_t>(content.size()), bytes);
  Append(kind, bytes);
  *bytes += content;
}

// JSON may write 1 as 1.0 or 10e-1; assimp then finds no number where it wants an index.
void WriteWholeNumbersSo(Json* value) {
  if (value->is_structured()) {
    for (Json& part : *value) WriteWholeNumbersSo(&part);
  } else if (value->is_number_float()) {
    const double number = value->get<double>();
    if (number >= 0.0 && number < 0x1p53 && number == std::floor(number) && !std::signbit(number))
      *value = static_cast<uint64_t>(number);
  }
}

std::string Text(const Json& value) { return value.is_string() ? value.get<std::string>() : ""; }

}  // namespace

const Json& Member(const Json& value, const std::string& key) {
  static const Json kNull;
  if (!value.is_object()) return kNull;
  const auto found = value.find(key);
  return found == value.end() ? kNull : *found;
}

const Json& Element(const Json& list, const Json& index) {
  static const Json kNull;
  if (!list.is_array() || !index.is_number_unsigned() || index.get<uint64_t>() >= list.size())
    return kNull;
  return list[index.get<size_t>()];
}

size_t Count(const Json& value, const std::string& key, size_t missing) {
  const Json& member = Member(value, key);
  return member.is_number_unsigned() ? member.get<size_t>() : missing;
}

Result<GltfDocument> ParseGltf(std::string_view bytes, const std::string& file) {
  GltfDocument document;
  document.is_glb = bytes.starts_with("glTF");
  std::string_view text = document.is_glb ? Chunk(bytes, kJsonChunk) : bytes;
  if (document.is_glb) document.binary = Chunk(bytes, kBinaryChunk);
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  document.json = Json::parse(text, nullptr, false);
  if (!document.json.is_object())
    return Error{ErrorCode::kSyntax, file, "", "its JSON is broken; export the file again"};
  WriteWholeNumbersSo(&document.json);
  const std::string version = Text(Member(Member(document.json, "asset"), "version"));
  if (!version.starts_with("2.")) {
    return Error{ErrorCode::kSchema, file, "asset.version",
                 (version.empty() ? "is missing" : "is " + version) +
                     ", but Hazumi reads glTF 2.0; export the file as glTF 2.0"};
  }
  return document;
}

std::string GltfBytes(const GltfDocument& document) {
  std::string text = document.json.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (!document.is_glb) return text;
  std::string chunks;
  AppendChunk(kJsonChunk, text, ' ', &chunks);
  if (!document.binary.empty()) AppendChunk(kBinaryChunk, document.binary, '\0', &chunks);
  std::string bytes = "glTF";
  Append(2, &bytes);
  Append(static_cast<uint32_t>(kHeader + chunks.size()), &bytes);
  return bytes + chunks;
}

namespace {

// Who wrote a file last says so; other programs may keep extras of what they have changed.
void NoteBodies(const Json& json, GltfNotes* notes) {
  if (!Text(Member(Member(json, "asset"), "generator")).starts_with("Hazumi")) return;
  for (const Json& node : Member(json, "nodes")) {
    const Json& written = Member(Member(node, "extras"), "hazumi");
    if (written.is_null()) continue;
    const std::string name = Text(Member(node, "name"));
    if (const auto body = BodyFromGltf(written)) {
      notes->bodies[name] = *body;
    } else {
      notes->damaged.push_back(name);
    }
  }
}

}  // namespace

GltfNotes NotesOf(const GltfDocument& document) {
  GltfNotes notes;
  NoteBodies(document.json, &notes);
  const Json& nodes = Member(document.json, "nodes");
  const Json& animations = Member(document.json, "animations");
  for (size_t a = 0; animations.is_array() && a < animations.size(); ++a) {
    for (const Json& channel : Member(animations[a], "channels")) {
      const Json& sampler = Element(Member(animations[a], "samplers"), Member(channel, "sampler"));
      const std::string interpolation = Text(Member(sampler, "interpolation"));
      const Json& target = Member(channel, "target");
      if (interpolation == "CUBICSPLINE") ++notes.num_splines;
      if (interpolation == "STEP") {
        notes.stepped.insert(std::to_string(a) + "/" +
                             Text(Member(Element(nodes, Member(target, "node")), "name")) + "/" +
                             Text(Member(target, "path")));
      }
    }
  }
  return notes;
}

}  // namespace hazumi
