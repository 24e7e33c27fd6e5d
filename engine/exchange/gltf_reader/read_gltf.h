#pragma once

// glTF 2.0 and GLB, by our own code; the JSON is parsed by nlohmann-json. See README.md.

#include <string_view>

#include "engine/base/result.h"
#include "engine/exchange/scene/scene.h"
#include "engine/exchange/scene/scene_folder.h"

namespace hazumi {

// `bytes` are those of the file; other files are read only from its folder.
Result<Scene> ReadGltf(std::string_view bytes, const std::string& file, SceneFolder* folder);

}  // namespace hazumi
