#pragma once

#include <vector>

#include "engine/passive/forces/force_law.h"

namespace hazumi {

// Forces of contacts and limits that stay what they are for a while, each with its point of the
// body and its direction in the world; moments turn with their bodies.
struct FrozenForces {
  struct Push {
    int node;
    Vec3 p_N;                                  // in the node's frame [m]
    Vec3 force;                                // [N]
    int on_other = -1;                         // which it pushes back at the same point; none: -1
    int link = -1, object = -1, by_link = -1;  // as ContactPush
  };
  struct Moment {
    int node;
    Vec3 moment_N;  // against its parent, in the node's frame [N m]
  };
  std::vector<Push> pushes;
  std::vector<Moment> moments;

  bool any() const { return !pushes.empty() || !moments.empty(); }
  void Clear() {
    pushes.clear();
    moments.clear();
  }
  // What goes from them into nodes that move so [W].
  double PowerIn(const RegionState& state) const {
    using namespace small;  // NOLINT(google-build-using-namespace): operators
    const auto& motion = state.kinematics.motion();
    double power = 0.0;
    for (const Push& push : pushes) {
      power += Dot(V3(push.force), state.VelocityAt(push.node, motion[push.node].R * V3(push.p_N)));
    }
    for (const Moment& own : moments) {
      const int parent = state.model.nodes[own.node].parent;
      const V3 w = parent < 0 ? V3() : motion[parent].w;
      power += Dot(motion[own.node].R * V3(own.moment_N), motion[own.node].w - w);
    }
    return power;
  }
  void AddTo(NodeKinematics* kinematics) const {
    using namespace small;  // NOLINT(google-build-using-namespace): operators
    for (const Push& push : pushes) {
      const V3 r = kinematics->motion()[push.node].R * V3(push.p_N);
      kinematics->AddForce(push.node, r, V3(push.force));
      if (push.on_other < 0) continue;
      const V3 from = kinematics->motion()[push.node].p - kinematics->motion()[push.on_other].p;
      kinematics->AddForce(push.on_other, from + r, -V3(push.force));
    }
    for (const Moment& own : moments) {
      kinematics->AddJointMoment(own.node, kinematics->motion()[own.node].R * V3(own.moment_N));
    }
  }
};

}  // namespace hazumi
