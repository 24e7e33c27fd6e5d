#pragma once

// Internal. Source that a project states: options that read a clip again as it was read.

#include "engine/exchange/import/world_frame.h"

namespace hazumi {

// `clip`: null if there is none. Its inverse is OptionsOf (import_project.h).
ProjectSource SourceOf(const Character& character, const Skeleton& skeleton, const Clip* clip,
                       const WorldFrame& world, const ImportOptions& options);

}  // namespace hazumi
