#include "engine/exchange/gltf/glb_chunks.h"

#include <bit>
#include <cstring>

namespace hazumi {

namespace {

static_assert(std::endian::native == std::endian::little, "numbers of a GLB are little-endian");

constexpr size_t kHeader = 12, kChunkHeader = 8, kWord = 4;

uint32_t NumberAt(std::string_view bytes, size_t offset) {
  uint32_t number = 0;
  if (offset + sizeof number <= bytes.size())
    std::memcpy(&number, bytes.data() + offset, sizeof number);
  return number;
}

void AppendNumber(size_t value, std::string* file) {
  const auto number = static_cast<uint32_t>(value);
  file->append(reinterpret_cast<const char*>(&number), sizeof number);
}

void AppendChunk(GlbChunk kind, const std::string& data, std::string* file) {
  AppendNumber(data.size(), file);
  AppendNumber(static_cast<size_t>(kind), file);
  *file += data;
}

}  // namespace

std::string_view ChunkOf(std::string_view glb, GlbChunk kind) {
  for (size_t at = kHeader; at + kChunkHeader <= glb.size();) {
    const size_t length = NumberAt(glb, at);
    if (NumberAt(glb, at + kWord) == static_cast<uint32_t>(kind))
      return glb.substr(at + kChunkHeader, length);
    at += kChunkHeader + length;
  }
  return {};
}

std::string OtherChunks(std::string_view glb) {
  const char* const text = ChunkOf(glb, GlbChunk::kJson).data();
  const char* const binary = ChunkOf(glb, GlbChunk::kBinary).data();
  std::string others;
  for (size_t at = kHeader; at + kChunkHeader <= glb.size();) {
    const std::string_view chunk = glb.substr(at, kChunkHeader + NumberAt(glb, at));
    const char* const data = chunk.data() + kChunkHeader;
    if (data != text && data != binary) others += chunk;
    at += kChunkHeader + NumberAt(glb, at);
  }
  return others;
}

Result<std::string> GlbFile(std::string text, std::string binary, const std::string& others) {
  const auto padded = [](size_t size) { return (size + kWord - 1) / kWord * kWord; };
  text.resize(padded(text.size()), ' ');
  binary.resize(padded(binary.size()));
  const size_t chunks = binary.empty() ? 1 : 2;
  const size_t total =
      kHeader + chunks * kChunkHeader + text.size() + binary.size() + others.size();
  if (total > 0xffffffffu) {
    return Error{ErrorCode::kSemantics, "", "", "more than the 4 GiB that a .glb can hold"};
  }
  std::string file = "glTF";
  AppendNumber(2, &file);
  AppendNumber(total, &file);
  AppendChunk(GlbChunk::kJson, text, &file);
  if (!binary.empty()) AppendChunk(GlbChunk::kBinary, binary, &file);
  return file + others;
}

}  // namespace hazumi
