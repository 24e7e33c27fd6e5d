#pragma once

// Roles of the bones of a skeleton in a body, told by the names of the bones and by what hangs on
// what.

#include <string>
#include <vector>

#include "engine/body/body_names.h"
#include "engine/figure/body_role.h"

namespace hazumi {

struct BoneRoles {
  std::vector<BodyPlace> places;  // by bone; all kNone if the names are not those of a body
  bool has_four_legs = false;
};

// Roles by the bones' names. A limb's role goes to the first bone of its part; the others of that
// part are twists. The spine is what lies between the hips and the neck, head or arms, whatever it
// is called. Front legs have the roles of arms.
BoneRoles RolesByName(const std::vector<NamedBone>& bones);

}  // namespace hazumi
