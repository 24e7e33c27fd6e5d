#pragma once

// Internal. What must not be of regions and held objects that touch the scene.

#include <vector>

#include "engine/base/warning.h"
#include "engine/project/checks/checks.h"
#include "engine/timeline/animation.h"

namespace hazumi {

void CheckContacts(const Animation& animation, FirstError* errors);

// Of those that can touch nothing, and of pins that contact leaves no work.
void WarnAboutContacts(const Animation& animation, std::vector<Warning>* warnings);

}  // namespace hazumi
