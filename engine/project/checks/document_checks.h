#pragma once

// Internal. What must hold of a project by itself, whatever the figure: ranges, order, names given
// twice.

#include "engine/project/checks/checks.h"
#include "engine/project/project.h"

namespace hazumi {

void CheckDocument(const Project& project, FirstError* errors);

}  // namespace hazumi
