#pragma once

#include "engine/dynamics/workspace.h"

namespace hazumi {

// One column of the inertia matrix, H_i = Dinv(q, 0, e_i, 0, 0, 0) [Arai (4)], without the terms
// that are zero: only bodies beyond joint i move, and only they and the chain down to the root
// transmit force. Needs ComputePositions. Writes the torques of the joints on that chain and beyond
// i to ws->tau (others are zero and are left alone) and the force on the root body [N] to
// ws->bodies[0].f.
void UnitAccelerationTorques(const Figure& figure, JointIndex i, DynamicsWorkspace* ws);

}  // namespace hazumi
