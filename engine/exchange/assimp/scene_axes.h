#pragma once

#include <assimp/scene.h>

#include "engine/exchange/character/character.h"
#include "engine/exchange/content.h"

namespace hazumi {

// Sets the character's up axis and unit from what the format or the file says, and takes off the
// scene's root what assimp put there for them, so that lengths and axes are the file's own.
void TakeAxesAndUnit(CharacterFormat format, aiScene* scene, Character* character);

}  // namespace hazumi
