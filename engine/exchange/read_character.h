#pragma once

// The one door for characters of other programs.

#include <string>

#include "engine/base/result.h"
#include "engine/child/reader_program.h"
#include "engine/exchange/character/character.h"
#include "engine/exchange/content.h"

namespace hazumi {

// Reads BVH, glTF 2.0, GLB, FBX or Collada, by content, in a process of its own. Errors name the
// file: not there or no regular file (kNoInput), of another format (kSyntax; says which are read),
// broken, or as ReadInChild has them.
Result<Character> ReadCharacter(const std::string& path, const ReadOptions& options = {});
// The meshes of a thing, on one bone, from glTF 2.0, GLB, FBX, Collada or OBJ. Errors: the same;
// kSemantics if it has none.
Result<Character> ReadThing(const std::string& path, const ReadOptions& options = {});

// Reads a file in a process of its own (engine/child). What comes back has been checked. Errors
// name the file: kInterrupted when cancelled; kFailed when the reader is missing; kSyntax when the
// file made it crash, or take too much time or memory.
Result<Character> ReadInChild(ReadUse use, const std::string& path,
                              const ReadOptions& options = {});

}  // namespace hazumi
