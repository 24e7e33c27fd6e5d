#include "engine/exchange/gltf_reader/document.h"

#include <cmath>
#include <cstdint>

#include "engine/exchange/gltf/glb_chunks.h"

namespace hazumi {
namespace {

using Json = nlohmann::json;

// JSON may write 1 as 1.0 or 10e-1; indices are whole numbers from here on.
void WriteWholeNumbersSo(Json* value) {
  if (value->is_structured()) {
    for (Json& part : *value) WriteWholeNumbersSo(&part);
  } else if (value->is_number_float()) {
    const double number = value->get<double>();
    if (number >= 0.0 && number < 0x1p53 && number == std::floor(number) && !std::signbit(number))
      *value = static_cast<uint64_t>(number);
  }
}

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

std::string Text(const Json& value) { return value.is_string() ? value.get<std::string>() : ""; }

std::vector<double> Numbers(const Json& value, size_t count) {
  std::vector<double> numbers;
  if (!value.is_array() || value.size() != count) return numbers;
  for (const Json& number : value) {
    if (!number.is_number()) return {};
    numbers.push_back(number.get<double>());
  }
  return numbers;
}

Result<GltfDocument> ParseGltf(std::string_view bytes, const std::string& file) {
  GltfDocument document;
  const bool is_glb = IsGlb(bytes);
  std::string_view text = is_glb ? ChunkOf(bytes, GlbChunk::kJson) : bytes;
  if (is_glb) document.binary = ChunkOf(bytes, GlbChunk::kBinary);
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

}  // namespace hazumi
