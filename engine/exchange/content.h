#pragma once

#include <string>
#include <string_view>

#include "engine/base/result.h"

namespace hazumi {

// The formats that characters are read from; OBJ: things alone.
enum class CharacterFormat { kBvh, kGltf, kGlb, kFbxBinary, kFbxText, kCollada, kObj };

// "BVH", "glTF", "GLB", "FBX", "Collada" or "OBJ".
const char* FormatName(CharacterFormat format);
// What a file is read for: a skeleton with its clips and skin, or all meshes as they lie at rest,
// on a single bone.
enum class ReadUse { kCharacter, kThing };

// Parts of a file to read.
struct ReadChoice {
  std::string character;  // name of one of several; empty: the one that moves most
  double rate = 0.0;      // sampling rate of clips [1/s]; 0: the clip's own
  // Whether each frame becomes a key: a BVH take with more keys than a project holds is refused by
  // its first rows.
  bool keys_all_frames = false;
};

// What a file is by its content, whatever it is called; `bytes` is all of it or its beginning, of
// kContentBytes at least. Of OBJ, which things are read from and characters not, the name decides;
// BVH has no meshes. Error (kSyntax): none of these; says what else it seems to be, and which are
// read.
Result<CharacterFormat> FormatOf(ReadUse use, std::string_view bytes, const std::string& file);
constexpr size_t kContentBytes = 65536;

}  // namespace hazumi
