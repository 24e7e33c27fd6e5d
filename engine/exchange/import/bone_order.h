#pragma once

// Internal. The order of a character's bones.

#include <vector>

#include "engine/exchange/character/character.h"

namespace hazumi {

// Reorders bones, tracks and binds; `from` has the old index of each new bone.
void Reorder(const std::vector<int>& from, Character* character);

// The same order but for parents, which come before their children.
void PutParentsFirst(Character* character);

}  // namespace hazumi
