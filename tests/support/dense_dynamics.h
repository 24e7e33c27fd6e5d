#pragma once

// Dynamics with the whole inertia matrix, as the paper prints it: slow, and what other routes are
// checked by.

#include <optional>

#include "engine/dynamics/inverse_dynamics.h"

namespace hazumi::test {

// The N x N inertia matrix [kg m^2] by N unit accelerations [Arai (4)]. Needs ComputePositions.
void InertiaMatrix(const Figure& figure, DynamicsWorkspace* ws, MatX* H);

// H qdd = T - B [Arai (2)] solved for qdd by a dense Cholesky factorisation, O(N^3). Needs
// ComputePositions. `root.a` is the acceleration of the root minus gravity. Where H is singular,
// which it is when a joint moves no mass, the first joint whose pivot is not positive.
std::optional<JointIndex> ForwardDynamics(const Figure& figure, const RootMotion& root,
                                          const VecX& qd, const VecX& tau, const EndForces* ends,
                                          DynamicsWorkspace* ws, VecX* qdd);

}  // namespace hazumi::test
