#pragma once

#include <vector>

#include "engine/passive/contact/contact_push.h"
#include "engine/passive/forces/force_law.h"

namespace hazumi {

// Forces of contacts and limits that stay what they are for a while, each with its point of the
// body and its direction in the world; moments turn with their bodies.
struct FrozenForces {
  struct Push {
    int node;
    Vec3 p_N;                     // in the node's frame [m]
    Vec3 force;                   // [N]
    int on_other = -1;            // which it pushes back at the same point; none: -1
    Vec3 p_other = Vec3::Zero();  // of that node, where the point was at first [m]
    ContactParts parts = {};
    Vec3 from = Vec3::Zero();  // where the point was at first, less where the other's was [m]
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
  // They begin to push, with bodies in these places.
  void Begin(const RegionState& state) {
    for (Push& push : pushes) push.from = PlaceOf(push, state);
  }
  // What pushes have given since [J].
  double WorkOfPushes(const RegionState& state) const {
    double work = 0.0;
    for (const Push& push : pushes) work += push.force.dot(PlaceOf(push, state) - push.from);
    return work;
  }
  // What moments give to nodes that turn so [W].
  double PowerOfMoments(const RegionState& state) const {
    const auto& motion = state.kinematics.motion();
    double power = 0.0;
    for (const Moment& own : moments) {
      const int parent = state.model.nodes[own.node].parent;
      const small::V3 w = motion[own.node].w - (parent < 0 ? small::V3() : motion[parent].w);
      power += Dot(motion[own.node].R * small::V3(own.moment_N), w);
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

 private:
  static Vec3 PlaceOf(const Push& push, const RegionState& state) {
    const auto& motion = state.kinematics.motion();
    const auto place = [&](int node, const Vec3& p_N) {
      return state.PositionAt(node, motion[node].R * small::V3(p_N)).eigen();
    };
    const Vec3 own = place(push.node, push.p_N);
    return push.on_other < 0 ? own : Vec3(own - place(push.on_other, push.p_other));
  }
};

}  // namespace hazumi
