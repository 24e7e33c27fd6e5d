#pragma once

// Internal: how a jump that is made leaves the ground and comes to it. The equations are in
// jump_contacts.cpp.

#include "ui/edit/operators/placement/jump_plan.h"

namespace hazumi::edit {

// Of a plan with its stances, whose poses are those of kJumpHinges: roots and frames as SetRoots
// and SetTimes have them, with leans at take-off and landing that suit the flight, and the rates
// there. Errors: theirs, and kSchema if the legs cannot give or take that flight's speed.
Result<Done> PlanContacts(const Animation& animation, const JumpSpots& spots, double height,
                          const JumpLengths& lengths, Stage* stage, JumpPlan* plan);

// The keys of a jump whose keys say how fast it takes off and lands say it as planned, with the
// leans there. Curves that have no such keys stay as they are.
void KeyContacts(const JumpPlan& plan, const Figure& figure, Project* project);

}  // namespace hazumi::edit
