#pragma once

// Internal. Body of a limb as one piece.

#include "engine/dynamics/workspace.h"
#include "engine/figure/figure.h"

namespace hazumi::makers {

// Inertia of all that turns with a hinge, in its frame: everything beyond it, but not beyond the
// hinge `next`, if that is valid. `ws`: positions of the bodies.
RigidInertia CarriedBody(JointIndex hinge, JointIndex next, const Figure& figure,
                         const DynamicsWorkspace& ws);

}  // namespace hazumi::makers
