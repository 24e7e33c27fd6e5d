#pragma once

// A character, or why there is none, as bytes: from the process that reads files to the one that
// asked. Versioned, of one machine's byte order; not a file format.

#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/exchange/character/character.h"

namespace hazumi {

std::string CharacterToBytes(const Result<Character>& character);

// The other way. Any bytes may come in: what does not hold a whole, checked character or an error
// is an Error (kSyntax, of `file`; kFailed if it is another version's). Allocates little more than
// `bytes` is long.
Result<Character> CharacterFromBytes(std::string_view bytes, const std::string& file);

}  // namespace hazumi
