#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/exchange/character/character.h"

namespace hazumi {

// Reads a file in this process, which a broken file may end: for hazumi-reader only, all others
// call ReadCharacter.
Result<Character> ReadHere(const std::string& path);
// The meshes of a thing, on one bone.
Result<Character> ReadThingHere(const std::string& path);

}  // namespace hazumi
