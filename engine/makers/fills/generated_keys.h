#pragma once

// Internal. A motion given frame by frame as keys between those of the animator.

#include <vector>

#include "engine/project/project.h"

namespace hazumi::makers {

// Whether a fill may put keys between a key of this interpolation and the next one: intervals that
// hold, are linear, quadratic or eased stay as they are.
constexpr bool MayBeFilled(Interpolation kind) {
  return kind == Interpolation::kCubic || IsOfRun(kind);
}

// Puts keys of the type generated into a curve, on some of the frames from `first` on: so that the
// curve is within `tolerance` of every value, and no key that is there changes. The first and the
// last value get keys, but not inside an interval that holds, is linear or eased. Returns the
// number of keys.
int PutGeneratedKeys(const std::vector<double>& values, int first, const ProjectRate& fps,
                     double tolerance, ProjectCurve* curve);

}  // namespace hazumi::makers
