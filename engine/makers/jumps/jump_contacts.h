#pragma once

// Internal: how a jump that is made leaves the ground and comes to it. The equations are in
// jump_contacts.cpp.

#include "engine/makers/jumps/jump_plan.h"

namespace hazumi::makers {

// Sets roots and frames as SetRoots and SetTimes do, leans at take-off and landing that suit the
// flight, and the rates there, of a plan whose stances are those of kJumpHinges. Errors: theirs,
// and kSchema if the legs cannot give or take that flight's speed.
Result<Done> PlanContacts(const Animation& animation, const JumpSpots& spots, double height,
                          const JumpLengths& lengths, Stage* stage, JumpPlan* plan);

// Keys the planned rates and leans at take-off and landing where keys there have rates. Other
// curves stay as they are.
void KeyContacts(const JumpPlan& plan, const Figure& figure, Project* project);

}  // namespace hazumi::makers
