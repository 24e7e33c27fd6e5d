#pragma once

#include <string>

#include "engine/base/result.h"
#include "engine/exchange/character/character.h"
#include "engine/exchange/content.h"

namespace hazumi {

// Reads a file in this process, which a broken file may end: for hazumi-reader only, all others
// call ReadCharacter.
Result<Character> ReadHere(ReadUse use, const std::string& path, const ReadChoice& choice);

}  // namespace hazumi
