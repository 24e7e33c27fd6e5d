#pragma once

#include "engine/base/result.h"
#include "ui/edit/session/session.h"

namespace hazumi::edit {

// What a session holds beside the project and operators depend on: current frame, what is selected,
// what was copied. Whoever gives a session more of it adds it here.
Json StateOf(const Session& session);

// Errors: kSchema, the place being the part that is missing or wrong; the session is as it was.
Result<Done> RestoreState(const Json& state, Session* session);

}  // namespace hazumi::edit
