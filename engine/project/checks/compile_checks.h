#pragma once

// Internal. What must hold between regions, placements and holds.

#include <atomic>

#include "engine/project/checks/checks.h"
#include "engine/project/compile.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// `animation` has its lists in the order of the project, which the places refer to. Takes n log n
// for n of them; ends early, with nothing found, where `cancel` is set.
void CheckAnimation(const Animation& animation, const std::atomic<bool>* cancel,
                    FirstError* errors);

// Odd, but no error.
void WarnAboutPlacements(const Animation& animation, std::vector<Warning>* warnings);

}  // namespace hazumi
