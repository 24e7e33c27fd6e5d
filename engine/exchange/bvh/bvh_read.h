#pragma once

#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/exchange/character/character.h"
#include "engine/exchange/content.h"

namespace hazumi {

// The character of a BVH file with its one clip, both named as the file. `file` is its path, for
// messages. Lengths and axes are those of the file, angles are radians; see README.md for what is
// accepted and how it is read. What was repaired is in `warnings`, each with its line. Of `choice`
// only the limit of keys counts, at its rate.
Result<Character> ReadBvh(std::string_view text, const std::string& file,
                          const ReadChoice& choice = {});

}  // namespace hazumi
