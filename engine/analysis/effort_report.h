#pragma once

#include <string>
#include <vector>

#include "engine/analysis/effort.h"

namespace hazumi {

// The largest torque and the largest share of a strength, with hinge and frame, what comes from
// nowhere, and how accelerations were found: a line each.
std::vector<std::string> EffortReport(const Animation& animation, const Motion& motion,
                                      const Effort& effort);
// One line of it: the largest share of a strength, or where none is known the largest torque. None
// of a motion without frames.
std::vector<std::string> BriefEffortReport(const Animation& animation, const Motion& motion,
                                           const Effort& effort);

}  // namespace hazumi
