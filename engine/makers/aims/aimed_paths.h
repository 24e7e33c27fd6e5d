#pragma once

// Internal. Hinges that an aim moves, limb by limb.

#include <vector>

#include "engine/makers/aims/aim_goals.h"

namespace hazumi::makers {

// Hinges in a row, from the figure outwards, each the parent of the next one.
struct AimedHinges {
  std::vector<JointIndex> path;
  std::vector<char> moves;  // by hinge of `path`: the aim may give it a torque
};

// One path for each joint of a goal with none beyond it, from the outermost limp hinge that moves
// it. Hinges that two paths share belong to the first one.
std::vector<AimedHinges> PathsOf(const std::vector<AimGoal>& goals, const DynamicsRegion& region,
                                 const Figure& figure);

// Goals that a path can meet, with the angles of its hinges.
std::vector<AimGoal> GoalsOf(const AimedHinges& hinges, const std::vector<AimGoal>& goals);

}  // namespace hazumi::makers
