#pragma once

// Internal. What must hold between forces from outside and regions.

#include <vector>

#include "engine/project/checks/checks.h"
#include "engine/project/compile.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// As CheckAnimation.
void CheckForces(const Animation& animation, FirstError* errors);

// Of those that nothing feels.
void WarnAboutForces(const Animation& animation, std::vector<Warning>* warnings);

}  // namespace hazumi
