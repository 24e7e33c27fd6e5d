#pragma once

// Internal. Whether what was made can be opened again.

#include <optional>

#include "engine/base/result.h"
#include "engine/exchange/import/world_frame.h"
#include "engine/project/project.h"

namespace hazumi {

// Why the figure is too large to be one; none: it is not.
std::optional<Error> WhyTooTall(const WorldFrame& world);

// Why a project cannot be read back from its file, or not animated: numbers larger than a file
// holds, too many joints or frames, a rate that no project has. None: it can.
std::optional<Error> WhyNoProject(const Project& project);

}  // namespace hazumi
