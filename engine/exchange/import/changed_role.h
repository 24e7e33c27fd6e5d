#pragma once

// Another role for a joint of a project: with its hinges, its limits and its keys.

#include <string>

#include "engine/base/result.h"
#include "engine/figure/body_role.h"
#include "engine/project/project.h"

namespace hazumi {

// Makes a joint another part of the body. If that part has hinges of its own, the joint gets them,
// and it and the joints that hang on it keep their poses at all their keys: each of their hinges
// has a key then wherever one of them had one. What has a role once, such as the right forearm,
// loses it to this joint. The rest of the figure stays. Errors leave the project as it was: the
// figure is a file of its own or mirrors its sides, the joint is not there, the role needs a side,
// or something names a hinge that would be gone.
Result<Done> ChangeRole(const std::string& joint, BodyPlace place, Project* project);

}  // namespace hazumi
