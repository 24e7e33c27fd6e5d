#pragma once

#include <memory>

#include "engine/region/node_motion.h"

namespace hazumi {

// A model whose driven hinges have as coordinates numbers from 0 on, in order of its nodes: there
// may be as many islands as joints, and each reads few curves.
RegionModel WithOwnCurves(RegionModel model);

// The curves that a model reads, by those numbers, and those of drives by free hinge; `driven` by
// the Coordinates of the figure. Where the root's position is not prescribed nobody reads it, and
// it is left out.
std::shared_ptr<const DrivenMotion> CurvesOf(const RegionModel& model, const DrivenMotion& driven);

}  // namespace hazumi
