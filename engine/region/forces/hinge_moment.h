#pragma once

#include "engine/region/node_motion.h"

namespace hazumi {

// The moment that gives hinges about one to three axes, unit vectors, these torques [N m]: the
// least one. Where three of them nearly line up it is less than that and stays finite; what it does
// then give a hinge is its component along that axis. Of two, no two may line up.
small::V3 MomentOfHinges(const small::V3* axes, int num_axes, const double* torques);
// On a node, against its parent; by dof of the node.
small::V3 MomentOfHinges(const NodeMotion& node, int num_dofs, const double* torques);
// The same, all of it up to a millionth of a radian from where three line up.
small::V3 FullMomentOfHinges(const NodeMotion& node, int num_dofs, const double* torques);

}  // namespace hazumi
