#pragma once

#include <vector>

#include "engine/region/contact/contact_push.h"
#include "engine/region/forces/force_law.h"
#include "engine/region/forces/hinge_moment.h"
#include "engine/spatial/pose.h"

namespace hazumi {

// Forces of contacts and limits in time-stepping mode, constant during a step. A contact force
// keeps its point on the body and its direction in the world; on a ball, which may roll, it keeps
// the point relative to the centre. Moments turn with their bodies. [METHOD 12.4]
struct StepForces {
  struct Push {
    int node;
    Vec3 p_N;                     // in the node's frame; of a ball along the world's axes [m]
    Vec3 force;                   // [N]
    int on_other = -1;            // which it pushes back at the same point; none: -1
    Vec3 p_other = Vec3::Zero();  // of that node, where the point was at first [m]
    ContactParts parts = {};
    Vec3 from = Vec3::Zero();        // where the point was at first, less where the other's was [m]
    Mat3 R_from = Mat3::Identity();  // and how the node was turned
  };
  struct Moment {
    int node;
    Vec3 moment_N;  // against its parent, in the node's frame [N m]
  };
  std::vector<Push> pushes;
  std::vector<Moment> moments;
  // Moments of implicit springs, constant during the same step.
  std::vector<Moment> springs;
  bool holds_springs = false;

  void Clear() {
    pushes.clear();
    moments.clear();
    springs.clear();
    holds_springs = false;
  }
  // Adds moments that give free hinges these torques [N m].
  void AddTorques(const VecX& torques, const RegionState& state) {
    const auto& motion = state.kinematics.motion();
    for (int i = 0; i < state.kinematics.size(); ++i) {
      const RegionLayout::Node& node = state.layout.node(i);
      if (node.num_dofs == 0) continue;
      const auto own = torques.segment(node.first_hinge, node.num_dofs);
      if (own.isZero(0.0)) continue;
      const small::V3 moment = FullMomentOfHinges(motion[i], node.num_dofs, own.data());
      moments.push_back({i, TransposeTimes(motion[i].R, moment).eigen()});
    }
  }
  // Begins a step, with bodies in these places.
  void Begin(const RegionState& state) {
    for (Push& push : pushes) {
      push.from = PlaceOf(push, state);
      push.R_from = OrientationOf(push, state);
    }
  }
  // Returns the work of contact forces since the begin of the step [J].
  double WorkOfPushes(const RegionState& state) const {
    double work = 0.0;
    for (const Push& push : pushes) {
      work += push.force.dot(PlaceOf(push, state) - push.from);
      if (!state.kinematics.is_ball(push.node)) continue;
      const Vec3 turn = TurnBetween(push.R_from, OrientationOf(push, state));
      work += push.p_N.cross(push.force).dot(turn);
    }
    return work;
  }
  // Returns the power of the moments on nodes that turn as in `state` [W].
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
  // Returns a point of a node relative to the node's origin, world axes.
  static small::V3 PointOn(const NodeKinematics& kinematics, int node, const Vec3& p_N) {
    const small::V3 p(p_N);
    return kinematics.is_ball(node) ? p : kinematics.motion()[node].R * p;
  }
  void AddTo(NodeKinematics* kinematics) const {
    using namespace small;  // NOLINT(google-build-using-namespace): operators
    for (const Push& push : pushes) {
      const V3 r = PointOn(*kinematics, push.node, push.p_N);
      kinematics->AddForce(push.node, r, V3(push.force));
      if (push.on_other < 0) continue;
      const V3 from = kinematics->motion()[push.node].p - kinematics->motion()[push.on_other].p;
      kinematics->AddForce(push.on_other, from + r, -V3(push.force));
    }
    AddMoments(moments, kinematics);
  }
  void AddSpringsTo(NodeKinematics* kinematics) const { AddMoments(springs, kinematics); }

 private:
  static void AddMoments(const std::vector<Moment>& moments, NodeKinematics* kinematics) {
    for (const Moment& own : moments) {
      kinematics->AddJointMoment(own.node,
                                 kinematics->motion()[own.node].R * small::V3(own.moment_N));
    }
  }
  static Mat3 OrientationOf(const Push& push, const RegionState& state) {
    return state.kinematics.motion()[push.node].R.eigen();
  }
  static Vec3 PlaceOf(const Push& push, const RegionState& state) {
    const auto place = [&](int node, const Vec3& p_N) {
      return state.PositionAt(node, PointOn(state.kinematics, node, p_N)).eigen();
    };
    const Vec3 own = place(push.node, push.p_N);
    return push.on_other < 0 ? own : Vec3(own - place(push.on_other, push.p_other));
  }
};

}  // namespace hazumi
