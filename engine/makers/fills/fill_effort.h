#pragma once

#include "engine/base/result.h"
#include "engine/project/project.h"

namespace hazumi::makers {

// Torque that the joints of a fill give in its frames: root of the mean square over hinges and
// frames, but for the two at either end [N m]. 0 where it moves none. Errors: those of
// CompileAnimation and Bake.
Result<double> TorqueIn(const ProjectFill& fill, const Project& project);

}  // namespace hazumi::makers
