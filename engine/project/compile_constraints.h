#pragma once

// Internal. From the document's constraints to the animation's.

#include "engine/project/checks/checks.h"
#include "engine/project/project.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// `animation` has its figure and objects; names have been checked. Reports held objects that are
// not in one hand all the time.
void AddConstraints(const Project& project, Animation* animation, FirstError* errors);

}  // namespace hazumi
