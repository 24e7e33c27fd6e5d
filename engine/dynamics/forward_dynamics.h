#pragma once

#include <optional>

#include "engine/dynamics/inverse_dynamics.h"

namespace hazumi {

// Forward dynamics finds the accelerations qdd [rad/s^2] that torques tau [N m] cause. It fails
// when the inertia matrix is singular, which happens when a joint moves no mass.
struct SingularInertia {
  JointIndex joint;  // the first joint whose pivot is not positive
};

// H qdd = T - B [Arai (2)], with H by unit accelerations and a dense Cholesky factorisation:
// O(N^3). Needs ComputePositions. `root.a` is the acceleration of the root minus gravity. For O(N)
// see figure_dynamics.h.
std::optional<SingularInertia> ForwardDynamicsDense(const Figure& figure, const RootMotion& root,
                                                    const VecX& qd, const VecX& tau,
                                                    const EndForces* ends, DynamicsWorkspace* ws,
                                                    VecX* qdd);

}  // namespace hazumi
