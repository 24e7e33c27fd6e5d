#pragma once

#include "engine/dynamics/kinematics.h"
#include "engine/dynamics/workspace.h"

namespace hazumi {

// Forces and moments from outside on the E end links [Arai 2.2: Kf, Kn]: 3 x E, world axes, the
// force acting at the origin of the end link's joint [N, N m]. Columns go with `EndJoints`.
struct EndForces {
  Eigen::Matrix3Xd Kf, Kn;
};

// True if nothing lies beyond joint j.
inline bool IsEndJoint(const Figure& figure, JointIndex j) {
  return figure.joint(j).subtree_end.value() == j.value() + 1;
}
// The joints with nothing beyond them, ascending. [Arai 2.1: J_end]
std::vector<JointIndex> EndJoints(const Figure& figure);

// T = Dinv(q, qd, qdd, a, Kf, Kn) [Arai (1)], by Luh, Walker and Paul's Newton-Euler recursion, in
// world axes. `root.a` is the acceleration of the root minus gravity; the paper's root does not
// turn, ours may (root.w, root.alpha). Needs ComputePositions; leaves the torques [N m] in ws->tau
// and the force and moment on the root body in ws->bodies[0].f, n. `ends` may be null.
void InverseDynamics(const Figure& figure, const RootMotion& root, const VecX& qd, const VecX& qdd,
                     const EndForces* ends, DynamicsWorkspace* ws);

// The bias vector B = Dinv(q, qd, 0, a, Kf, Kn) [Arai (3)] is InverseDynamics with qdd = 0.

// One column of the inertia matrix, H_i = Dinv(q, 0, e_i, 0, 0, 0) [Arai (4)], without the terms
// that are zero: only bodies beyond joint i move, and only they and the chain down to the root
// transmit force. Needs ComputePositions. Writes the torques of the joints on that chain and beyond
// i to ws->tau (others are zero and are left alone) and the force on the root body [N] to
// ws->bodies[0].f.
void UnitAccelerationTorques(const Figure& figure, JointIndex i, DynamicsWorkspace* ws);

}  // namespace hazumi
