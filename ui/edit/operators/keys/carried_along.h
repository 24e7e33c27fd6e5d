#pragma once

// Internal: what goes along with keys that are moved or stretched in time.

#include <functional>

#include "ui/edit/session/key_selection.h"

namespace hazumi::edit {

// Where a frame goes.
using FrameMap = std::function<double(double)>;

// The selected keys are about to go to other frames. If they are all keys from the first to the
// last of them, then whatever else has a frame in between goes to the nearest whole frame there:
// the ends of regions, placements and holds, markers, and the release of objects. If they are all
// keys of the joints of a region alone, the ends of that region go. Keys on a single frame take
// nothing along: they are moved within what is around them.
void CarryAlong(const KeySelection& selected, const Figure& figure, const FrameMap& to,
                Project* project);

}  // namespace hazumi::edit
