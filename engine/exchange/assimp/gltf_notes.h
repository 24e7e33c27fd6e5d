#pragma once

// What glTF says and assimp 5.2.5 does not pass on or gets wrong, from the JSON itself.

#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/exchange/assimp/scene_clips.h"

namespace hazumi {

struct GltfNotes {
  SteppedChannels stepped;  // channels of interpolation STEP
  int num_splines = 0;      // channels of interpolation CUBICSPLINE
};

// Error: not JSON, not version 2, or something that assimp would read wrongly.
Result<GltfNotes> InspectGltf(std::string_view bytes, const std::string& file);

}  // namespace hazumi
