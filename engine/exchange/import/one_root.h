#pragma once

#include <optional>
#include <vector>

#include "engine/exchange/character/character.h"

namespace hazumi {

// Character with one root, made of one with several. A figure has one root, which alone moves from
// place to place. Several branches have a common parent that neither moves nor carries skin
// (`wanted` by bone), and at least one branch moves from place to place: the largest of these
// becomes the root, the others become its children. Every frame shows all bones where they were. A
// warning names the branches. None: the character has one root already.
std::optional<Character> WithOneRoot(const std::vector<char>& wanted, const Character& character);

}  // namespace hazumi
