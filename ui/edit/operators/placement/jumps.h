#pragma once

// Internal.

#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

// The operator jump.aim.
Result<Done> AimJump(Session* session, const Parameters& p);

}  // namespace hazumi::edit
