#pragma once

#include "engine/project/project.h"

namespace hazumi::edit {

// Gives an id to each item of the project's lists that has none, or has that of one before it, as a
// copy of an item has. Ids are given in order, from `next` on, which moves on.
void GiveIds(Project* project, int* next);

}  // namespace hazumi::edit
