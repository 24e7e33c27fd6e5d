#pragma once

#include <vector>

#include "engine/dynamics/lane_plan.h"

namespace hazumi {

// The bodies of a figure as the plan wants them, parents first, steps and lanes left open.
std::vector<LaneBody> MergeConcentricHinges(const Figure& figure);

// Gives every body a step and a lane, `width` lanes a step, longest chains first. Returns the
// number of steps.
int ScheduleBodies(int width, std::vector<LaneBody>* bodies);

}  // namespace hazumi
