#pragma once

#include "engine/base/result.h"
#include "engine/exchange/content.h"
#include "engine/exchange/scene/scene.h"
#include "engine/exchange/scene/scene_folder.h"

namespace hazumi {

// The character of a scene, or all its meshes on one bone that is the scene's root. `file` is the
// scene's path. Errors: what keeps it from being read, and what to do.
Result<Character> CharacterOf(ReadUse use, Scene scene, const ReadChoice& choice,
                              SceneFolder* folder, const std::string& file);

}  // namespace hazumi
