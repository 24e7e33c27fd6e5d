#pragma once

#include <string>
#include <string_view>

#include "engine/base/result.h"

namespace hazumi {

// The formats that characters are read from.
enum class CharacterFormat { kBvh, kGltf, kGlb, kFbxBinary, kFbxText, kCollada };

// "BVH", "glTF", "GLB", "FBX" or "Collada".
const char* FormatName(CharacterFormat format);
// "BVH (.bvh), glTF 2.0 (.gltf, .glb), ...": for messages.
const char* FormatsThatAreRead();

// What a file is by its content, whatever it is called; `bytes` is all of it or its beginning, of
// kContentBytes at least. Error (kSyntax): none of these; says what else it seems to be.
Result<CharacterFormat> FormatOf(std::string_view bytes, const std::string& file);
constexpr size_t kContentBytes = 65536;

}  // namespace hazumi
