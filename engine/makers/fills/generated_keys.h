#pragma once

// Internal. A motion given frame by frame as keys between those of the animator.

#include <vector>

#include "engine/project/project.h"

namespace hazumi::makers {

// Puts keys of the type generated into a curve, on some of the frames from `first` on: so that the
// curve is within `tolerance` of every value, and no key that is there changes. The first and the
// last value get keys, but not inside an interval that holds, is linear or eased. Returns the
// number of keys.
int PutGeneratedKeys(const std::vector<double>& values, int first, const ProjectRate& fps,
                     double tolerance, ProjectCurve* curve);

}  // namespace hazumi::makers
