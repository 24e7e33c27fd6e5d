#pragma once

#include <assimp/scene.h>

#include "engine/exchange/content.h"
#include "engine/exchange/scene/scene.h"

namespace hazumi {

// Sets the scene's up axis and unit from what the format or the file says, and takes off the
// scene's root what assimp put there for them, so that lengths and axes are the file's own.
void TakeAxesAndUnit(CharacterFormat format, aiScene* from, Scene* scene);

}  // namespace hazumi
