#pragma once

#include "engine/passive/node_motion.h"

namespace hazumi {

// The moment on a node, against its parent, that gives its free hinges these torques [N m], by dof
// of the node: the least one. No two of its axes may line up.
small::V3 MomentOfHinges(const NodeMotion& node, int num_dofs, const double* torques);

}  // namespace hazumi
