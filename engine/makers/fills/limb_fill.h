#pragma once

// Internal. The motion of one limb with the least effort.

#include <map>
#include <utility>

#include "engine/makers/fills/filled_figure.h"
#include "engine/makers/fills/limbs.h"
#include "engine/project/project.h"

namespace hazumi::makers {

// Filled joints of a limb, and their motion.
using LimbSplines = std::map<GroupIndex, std::pair<const FilledJoint*, JointTurns*>>;

// Replaces the splines of a limb, from the first joint that is filled to the last one, by the
// motion of least effort on the figure as it moves.
void FillLimb(const Limb& limb, const LimbSplines& splines, const ProjectFill& fill,
              const Animation& animation, FilledFigure* figure);

}  // namespace hazumi::makers
