#pragma once

// Internal: turning a body by the hinges that carry it.

#include <vector>

#include "engine/dynamics/workspace.h"
#include "engine/figure/figure.h"

namespace hazumi::edit {

// Changes the angles `q` of `hinges`, each beyond the one before, so that a body beyond them is
// turned as R_WB in the world, within their limits or as nearly as they can. `body`: the joint that
// moves it. `ws`: where everything is with the angles as they are. What is left [rad].
double TurnHinges(JointIndex body, const Mat3& R_WB, const std::vector<JointIndex>& hinges,
                  const Figure& figure, const DynamicsWorkspace& ws, VecX* q);

// Of hinges that may turn, those that turn the body of a joint without moving its origin, from the
// root outwards: its own and those of the joint before whose axes go through it (a pronation).
std::vector<JointIndex> TurnInPlace(GroupIndex joint, const std::vector<JointIndex>& may_turn,
                                    const Figure& figure, const DynamicsWorkspace& ws);

}  // namespace hazumi::edit
