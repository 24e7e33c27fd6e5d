#pragma once

// Internal: what the operators of objects share, of the scene or held.

#include <string>

#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

// Makes constraints name an object as it is called now.
void RenameObject(const std::string& from, const std::string& to, Project* project);

// Errors: kSchema if a constraint is fixed to it.
Result<Done> ExpectUnconstrained(const std::string& object, const Project& project);

// The holder by the parameter "joint"; not given: the first selected joint. Errors: kSchema if
// there is none.
Result<GroupIndex> HolderGiven(const Session& session, const Parameters& p);
// Where an object that is turned so in the holder's frame lies there [m]: half way along the first
// link, beside it, towards the figure's middle: the palm of the shipped human's hands.
Vec3 InThePalm(const Figure& figure, GroupIndex holder, const ProjectHeldObject& object,
               const Vec3& rotation_deg);
// R = Rz Ry Rx of a turn in a hand.
Mat3 TurnOf(const Vec3& rotation_deg);

// One undo step on the object of the parameter "object".
Result<Done> ChangeHeld(Session* session, const Parameters& p, const char* label,
                        const std::function<Result<Done>(ProjectHeldObject*)>& change);

}  // namespace hazumi::edit
