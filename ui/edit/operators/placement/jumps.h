#pragma once

// Internal: a jump that a project has.

#include <optional>

#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

// Of Project::placements: a flight by gravity from one pin to another.
struct JumpSpans {
  size_t before = 0, flight = 0, after = 0;
};
// That of the frame, its last one not included; nothing if there is none.
std::optional<JumpSpans> JumpAt(double frame, const Project& project);

// The operator jump.aim.
Result<Done> AimJump(Session* session, const Parameters& p);

}  // namespace hazumi::edit
