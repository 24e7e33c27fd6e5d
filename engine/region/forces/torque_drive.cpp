// A hinge gets tau(t) about its axis. Those of a node together are one moment on it, against its
// parent (MomentOfHinges); a hinge that rests on a limit passes its own on to what holds it there.

#include "engine/region/forces/torque_drive.h"

#include <algorithm>

#include "engine/region/forces/hinge_moment.h"

namespace hazumi {

using small::V3;

V3 TorqueDrive::MomentOn(int node, const RegionState& state) const {
  const RegionLayout::Node& own = state.layout.node(node);
  const NodeMotion& motion = state.kinematics.motion()[node];
  const auto torque_of = [&](int hinge) {
    return spec_.is_driven[hinge] ? state.driven.drives[hinge].At(state.t).v : 0.0;
  };
  double torques[3] = {};
  if (own.kind == RegionLayout::NodeKind::kBall) {
    const HingeTriple& triple = *state.layout.triple(node);
    const Mat3 R = RotationOfQuaternion(state.positions + own.position);
    // The side of the poles that it was on last; beyond one the middle axis points the other way.
    const Vec3 q = triple.Angles(R, Vec3(own.angle.data()), /*keeps_side=*/true);
    const Mat3 in_body = triple.AxesInBody(q);
    V3 axes[3];
    for (int k = 0; k < 3; ++k) {
      axes[k] = motion.R * V3(Vec3(in_body.col(k)));
      torques[k] = torque_of(own.first_hinge + k);
    }
    return MomentOfHinges(axes, 3, torques);
  }
  for (int h = 0, free = 0; free < own.num_dofs; ++h) {
    if (!own.locked[h]) torques[free++] = torque_of(own.first_hinge + h);
  }
  return MomentOfHinges(motion, own.num_dofs, torques);
}

void TorqueDrive::AddForces(const RegionState& state, NodeKinematics* kinematics) const {
  const auto& nodes = state.layout.nodes();
  for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
    if (nodes[i].num_dofs == 0) continue;
    const auto first = spec_.is_driven.begin() + nodes[i].first_hinge;
    if (std::find(first, first + state.model.nodes[i].num_hinges, 1) ==
        first + state.model.nodes[i].num_hinges) {
      continue;
    }
    kinematics->AddJointMoment(i, MomentOn(i, state));
  }
}

}  // namespace hazumi
