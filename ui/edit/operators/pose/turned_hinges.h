#pragma once

// Internal: turning a body by the hinges that carry it, and a limb about the line from its first
// joint to its end, which stays.

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

// From the joint that stays, a wrist or an ankle, to the first one, which turns.
struct Limb {
  GroupIndex end, first;
};

// Changes the angles `q` of `hinges`, the first joint's, so that the limb goes round by `angle`
// [rad], or as far as their limits let it, in steps so that it goes the way that the eye follows.
// `ws`: where everything is with the angles as they are. How far it went [rad].
double TurnLimb(double angle, const Limb& limb, const std::vector<JointIndex>& hinges,
                const Figure& figure, const DynamicsWorkspace& ws, VecX* q);

// Turns a limb out of the body that it hangs on, by the least angle that does, if a part between
// its first joint and its end, such as a forearm, is inside of that body. Leaves the limb as it is
// if no angle does. `X_WR`: the root in the world.
void TurnOutOfBody(const Limb& limb, const std::vector<JointIndex>& hinges, const Figure& figure,
                   const hazumi::Pose& X_WR, VecX* q);

}  // namespace hazumi::edit
