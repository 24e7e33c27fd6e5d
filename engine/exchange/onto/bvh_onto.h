#pragma once

// Internal. Changed bones in a BVH file.

#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/exchange/character/character.h"
#include "engine/exchange/onto/edited_bones.h"

namespace hazumi {

// The file with other numbers for changed bones in changed frames, to six decimals; frames beyond
// its last are more rows. Angles go on from those of the frame before. `source`: what was read of
// it. Errors, kSemantics: rows that are not the clip's frames; a bone that is turned or moved as it
// has no channels for.
Result<std::string> BvhOnto(std::string_view text, const Character& source, const EditedClip& clip);

}  // namespace hazumi
