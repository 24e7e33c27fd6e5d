#pragma once

#include "engine/figure/figure.h"
#include "engine/project/project.h"

namespace hazumi::edit {

// Keys the hinges of a region, and the root's turn if it drives that, on its first frame: with the
// value and the rate that their curves have there, so that keys inside the region, which are not
// used, do not change the way into it. The curves run as before. Left as it is is what has a key
// there, and what another region has moved since its last key.
void KeyRegionStart(const ProjectRegion& region, const Figure& figure, Project* project);

}  // namespace hazumi::edit
