#pragma once

// The one door for characters of other programs.

#include "engine/exchange/reader/read_in_child.h"

namespace hazumi {

// Reads BVH, glTF 2.0, GLB, FBX or Collada, by content, in a process of its own (see
// read_in_child.h). Errors name the file: not there or no regular file (kNoInput), of another
// format (kSyntax; says which are read), broken, or as ReadInChild has them.
Result<Character> ReadCharacter(const std::string& path, const ReadOptions& options = {});
// The meshes of a thing, on one bone, from glTF 2.0, GLB, FBX, Collada or OBJ. Errors: the same;
// kSemantics if it has none.
Result<Character> ReadThing(const std::string& path, const ReadOptions& options = {});

}  // namespace hazumi
