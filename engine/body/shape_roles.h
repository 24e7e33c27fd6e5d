#pragma once

// Roles of the bones of a skeleton in a body, told by its shape alone, where names say nothing.

#include <vector>

#include "engine/body/body_axes.h"

namespace hazumi {

// Sets the roles of bones at rest, z up, of a body on two legs: the hips are the bone from which
// two branches go down and one goes up; the arms leave the one that goes up together. The toes tell
// where the front is, or else x is. False, and nothing is set, if that is not how the bones hang
// together.
bool SetRolesByShape(std::vector<RestBone>* bones);

}  // namespace hazumi
