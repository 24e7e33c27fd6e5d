#pragma once

#include <string>
#include <string_view>

#include "engine/base/result.h"

namespace hazumi {

// The formats that characters are read from; OBJ: things alone.
enum class CharacterFormat { kBvh, kGltf, kGlb, kFbxBinary, kFbxText, kCollada, kObj };

// "BVH", "glTF", "GLB", "FBX", "Collada" or "OBJ".
const char* FormatName(CharacterFormat format);
// "BVH (.bvh), glTF 2.0 (.gltf, .glb), ...": for messages.
const char* FormatsThatAreRead();

// What a file is by its content, whatever it is called; `bytes` is all of it or its beginning, of
// kContentBytes at least. Error (kSyntax): none of these; says what else it seems to be.
Result<CharacterFormat> FormatOf(std::string_view bytes, const std::string& file);
// The same of a file that has the mesh of a thing: not BVH, and OBJ, which is known by its name.
Result<CharacterFormat> MeshFormatOf(std::string_view bytes, const std::string& file);
constexpr size_t kContentBytes = 65536;

}  // namespace hazumi
