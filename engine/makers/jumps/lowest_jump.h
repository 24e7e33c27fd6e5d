#pragma once

// Internal.

#include <functional>

#include "engine/makers/jumps/jumps.h"

namespace hazumi::makers {

// Jumps so high [m] in a project, which it changes.
using JumpSoHigh = std::function<Result<JumpReport>(double height, Project* project)>;
// Jumps as high as is given or, if no height is, as low as it gets there.
Result<MadeJump> JumpAsLow(std::optional<double> height, const JumpSoHigh& jump,
                           const Project& project);

}  // namespace hazumi::makers
