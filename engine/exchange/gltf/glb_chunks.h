#pragma once

// The container of a GLB file [glTF 2.0, 4].

#include <cstdint>
#include <string>
#include <string_view>

#include "engine/base/result.h"

namespace hazumi {

enum class GlbChunk : uint32_t { kJson = 0x4E4F534A, kBinary = 0x004E4942 };

inline bool IsGlb(std::string_view bytes) { return bytes.starts_with("glTF"); }

// The first chunk of a kind; empty: none.
std::string_view ChunkOf(std::string_view glb, GlbChunk kind);

// All chunks but the first ones of these two kinds, with their headers.
std::string OtherChunks(std::string_view glb);

// A file of these chunks, the first two padded to whole words; `binary` may be empty. Error,
// kSemantics: it would be longer than 4 GiB.
Result<std::string> GlbFile(std::string text, std::string binary, const std::string& others = "");

}  // namespace hazumi
