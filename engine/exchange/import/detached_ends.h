#pragma once

#include <optional>
#include <vector>

#include "engine/exchange/character/character.h"

namespace hazumi {

// Hangs hands, feet and paws that rigs keep beside their limbs, since handles move them, back on
// those limbs. Such an end keeps its place at the limb's last bone in most frames of the clips, and
// not in its parent; without clips it is a hand or a foot by its name, and lies where the forearm
// or the shin of its side ends. Poses of all frames stay as they are. `wanted`: WantedBones. None:
// there is nothing to hang.
std::optional<Character> WithEndsOnLimbs(const std::vector<char>& wanted,
                                         const Character& character);

}  // namespace hazumi
