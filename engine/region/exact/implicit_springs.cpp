// A spring gives its joint the moment M - K phi - D (w - w_0) as the joint turns by phi and with w.
// With S the axes of its hinges, w_0 at the start and dw = S dq' the change in a step of h seconds
// [Baraff, Witkin 1998]:
//   mass matrix  + S^T (h D + h^2 K) S,   b  + S^T h K w_0
//   moment at the end  M - h K (w_0 + dw) - D dw

#include "engine/region/exact/implicit_springs.h"

namespace hazumi {

namespace {

Eigen::Matrix3Xd AxesOf(const JointSpring& spring, const RegionState& state) {
  const auto& axes = state.kinematics.motion()[spring.node].axis;
  Eigen::Matrix3Xd all(3, state.layout.node(spring.node).num_dofs);
  for (Eigen::Index i = 0; i < all.cols(); ++i) all.col(i) = axes[static_cast<size_t>(i)].eigen();
  return all;
}

// Angular velocity of the node of a spring relative to the parent [rad/s].
Vec3 TurningOf(const JointSpring& spring, const RegionState& state) {
  using namespace small;  // NOLINT(google-build-using-namespace): operators
  const auto& motion = state.kinematics.motion();
  const int parent = state.model.nodes[spring.node].parent;
  return (motion[spring.node].w - (parent < 0 ? V3() : motion[parent].w)).eigen();
}

}  // namespace

void ImplicitSprings::AddTo(double h, const RegionState& state, MatX* M, VecX* b) const {
  for (const JointSpring& own : springs_) {
    const Eigen::Matrix3Xd axes = AxesOf(own, state);
    const Eigen::Index first = state.layout.node(own.node).first_hinge, n = axes.cols();
    M->block(first, first, n, n) +=
        axes.transpose() * (h * (own.damping + h * own.stiffness)) * axes;
    b->segment(first, n) += axes.transpose() * (h * (own.stiffness * TurningOf(own, state)));
  }
}

void ImplicitSprings::Keep(double h, const VecX& change, const RegionLaws& laws,
                           const RegionState& state, StepForces* constant) const {
  constant->holds_springs = true;
  for (const JointSpring& own : springs_) {
    const Eigen::Matrix3Xd axes = AxesOf(own, state);
    const Vec3 by = axes * change.segment(state.layout.node(own.node).first_hinge, axes.cols());
    Vec3 moment = own.moment;
    moment -= h * (own.stiffness * (TurningOf(own, state) + by)) + own.damping * by;
    moment = laws.LimitSprings(state, own.node, moment);
    const Mat3 R_WN = state.kinematics.motion()[own.node].R.eigen();
    constant->springs.push_back({own.node, R_WN.transpose() * moment});
  }
}

}  // namespace hazumi
