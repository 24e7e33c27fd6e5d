#pragma once

#include <vector>

#include "ui/edit/session/session.h"

namespace hazumi::test {

// Of a session's held objects those that operators ask for.

// What later holders have, too.
std::vector<ProjectHeldObject> PassedOn(const edit::Session& session);
// What is let go of while there is a region that may move the arm.
std::vector<ProjectHeldObject> Thrown(const edit::Session& session);
// What a hand has in the current frame, with no region in the way of a throw.
std::vector<ProjectHeldObject> InAHand(const edit::Session& session);

}  // namespace hazumi::test
