#pragma once

// Internal: how fast regions let their joints go.

#include <string>

#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

// Whether its speed at the start is what another region, which ends there, leaves it with.
bool IsTakenOver(const DynamicsRegion& region, JointIndex hinge, const Animation& animation);

// The key on a frame; made with the value that is seen there if there is none.
Result<ProjectKey> KeyAtStart(const std::string& hinge, int frame, Session* session);

}  // namespace hazumi::edit
