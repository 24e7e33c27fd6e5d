#pragma once

// Internal. Joints of a figure that is made from bones.

#include <vector>

#include "engine/exchange/import/joint_plan.h"
#include "engine/exchange/import/skeleton.h"
#include "engine/exchange/import/world_frame.h"
#include "engine/figure/figure_spec.h"

namespace hazumi {

// The joints that were planned, with limits, strength and links (by kept bone, with their masses).
// A leg without a foot gets a joint at its end that does not turn, for pins to hold.
std::vector<JointSpec> JointsOf(const Skeleton& skeleton, const FigurePlan& plan,
                                const std::vector<std::vector<LinkSpec>>& links,
                                const WorldFrame& world, ImportLimits limits, ImportReport* report);

}  // namespace hazumi
