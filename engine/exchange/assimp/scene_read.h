#pragma once

// FBX, glTF 2.0, GLB, Collada and OBJ by assimp. A broken file may crash this process:
// hazumi-reader calls it, nothing else.

#include <string>

#include "engine/base/result.h"
#include "engine/exchange/character/character.h"
#include "engine/exchange/content.h"

namespace hazumi {

// `bytes` are those of the file at `path`, of this format; other files are read only from the
// folder it lies in. See README.md for what is taken and how.
Result<Character> ReadScene(CharacterFormat format, ReadUse use, std::string bytes,
                            const std::string& path);

}  // namespace hazumi
