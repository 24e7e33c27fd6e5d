#pragma once

#include <functional>

#include "engine/project/edits/key_selection.h"

namespace hazumi {

// Returns the new frame of a frame.
using FrameMap = std::function<double(double)>;

// Moves what goes along with selected keys that are about to be moved in time. If they are all keys
// from the first to the last of them, everything else with a frame in between goes to the nearest
// whole frame there: ends of regions, placements, holds, forces and constraints, markers, and
// frames in which objects are let go. If they are all keys of the joints of one region, the ends of
// that region go. Keys on a single frame take nothing along.
void CarryAlong(const KeySelection& selected, const Figure& figure, const FrameMap& to,
                Project* project);

}  // namespace hazumi
