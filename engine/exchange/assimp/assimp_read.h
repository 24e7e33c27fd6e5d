#pragma once

// FBX, Collada and OBJ by assimp. A broken file may crash this process: hazumi-reader calls it,
// nothing else.

#include <string>

#include "engine/base/result.h"
#include "engine/exchange/content.h"
#include "engine/exchange/scene/scene.h"
#include "engine/exchange/scene/scene_folder.h"

namespace hazumi {

// `bytes` are those of the file at `path`, of this format; other files are read only from the
// folder it lies in. See README.md for what is taken and how.
Result<Scene> ReadByAssimp(CharacterFormat format, std::string bytes, const std::string& path,
                           SceneFolder* folder);

}  // namespace hazumi
