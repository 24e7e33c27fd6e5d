#pragma once

#include <array>
#include <optional>
#include <tuple>
#include <vector>

#include "engine/figure/figure.h"
#include "engine/region/region_system.h"
#include "engine/spatial/body_motion.h"

namespace hazumi {

// A rotation that a curve, a region or nobody moves: the figure's N hinges, by JointIndex, followed
// by the root's hinges about z, y and x.
using Coordinate = int;
constexpr int kRootAngles = 3;

enum class Role : char {
  kConstant,  // keeps its angle
  kDriven,    // moves as a curve says
  kFree,      // moves by its inertia
};

// What a stretch of time asks of the figure.
struct ModelRequest {
  std::vector<Role> roles;  // by Coordinate, N + 3; the root's three have one role
  VecX angles;              // [rad], by Coordinate; read where constant
  RootCoupling coupling = RootCoupling::kPrescribed;
  JointIndex pin;             // kPinned: the joint whose origin stays
  bool lists_joints = false;  // in RegionModel::joints, for laws that act on links
  // Joints whose bodies constraints tie to each other; an invalid one is the root, none the world.
  // Asks for lists_joints.
  struct Tie {
    std::optional<JointIndex> a, b;
  };
  std::vector<Tie> ties = {};
};

// One of the concentric hinges of a node.
struct NodeHinge {
  Coordinate coordinate = 0;
  Vec3 axis = Vec3::Zero();  // unit, in the node's frame at angle zero of all hinges of the node
  int cardinal = 3;          // 0, 1, 2: the axis is x, y, z times `sign`; 3: something else
  double sign = 1.0;         // or -1
};
inline auto MembersOf(const NodeHinge& hinge) {
  const auto& [coordinate, axis, cardinal, sign] = hinge;
  return std::tie(coordinate, axis, cardinal, sign);
}

// Rigid body on up to three concentric hinges, all free or all driven. Its frame is parallel to its
// parent's where all its hinges are at zero.
struct ModelNode {
  int parent = -1;          // -1: the root's translation
  Vec3 p_P = Vec3::Zero();  // its origin in the parent's frame [m]
  Role role = Role::kConstant;
  int num_hinges = 0;
  std::array<NodeHinge, 3> hinges;
  bool is_ball = false;     // free, and its hinges are a HingeTriple
  bool is_dynamic = false;  // at or beyond a free node, or every node where the root answers
  RigidInertia body;        // about its frame; massless if not dynamic
};
inline auto MembersOf(const ModelNode& node) {
  const auto& [parent, p_P, role, num_hinges, hinges, is_ball, is_dynamic, body] = node;
  return std::tie(parent, p_P, role, num_hinges, hinges, is_ball, is_dynamic, body);
}

// A joint, with all that is fixed to it, on the node that it moves with.
struct NodeJoint {
  JointIndex joint;  // none: the root
  int node = 0;
  Vec3 p_N = Vec3::Zero();       // its origin in the node's frame [m]
  Mat3 R_NJ = Mat3::Identity();  // its orientation there, after it has turned
};
inline auto MembersOf(const NodeJoint& seat) {
  const auto& [joint, node, p_N, R_NJ] = seat;
  return std::tie(joint, node, p_N, R_NJ);
}

inline Vec3 OnNode(const NodeJoint& seat, const Vec3& p_J) { return seat.p_N + seat.R_NJ * p_J; }

// A ball that flies beside the figure, a rigid body of its own; only contacts tie them.
struct LooseBall {
  double mass = 0.0, inertia = 0.0;  // about any axis through its centre [kg, kg m^2]
  int object = 0;                    // among those that are held, for those who are told

  double KineticEnergy(const BodyMotion& motion) const {  // [J]
    return 0.5 * mass * motion.v.squaredNorm() + 0.5 * inertia * motion.w.squaredNorm();
  }
  double PotentialEnergy(const BodyMotion& motion, double gravity) const {
    return mass * gravity * motion.X_WB.p.z();
  }
};
inline auto MembersOf(const LooseBall& ball) {
  const auto& [mass, inertia, object] = ball;
  return std::tie(mass, inertia, object);
}

// The least model of one island of free joints that feel each other [METHOD 6]: links that move
// rigidly together are one body, concentric hinges one rotation, and what lies outside is there
// only as the chain that moves the moving base.
struct RegionModel {
  std::vector<ModelNode> nodes;    // parents first; node 0 is the root body
  Mat3 R_root = Mat3::Identity();  // orientation of node 0 at angles zero, or where it is constant
  RootCoupling coupling = RootCoupling::kPrescribed;
  int pin_node = -1;          // kPinned: the pin's origin is fixed to this node
  Vec3 p_pin = Vec3::Zero();  // in its frame [m]
  // True if the root's translation depends on the free joints.
  bool root_answers = false;
  double mass = 0.0;   // of all dynamic nodes [kg]
  int num_free = 0;    // free hinges
  int num_bodies = 0;  // dynamic nodes with mass
  // On dynamic nodes, by node, but for those that turn within one; none unless asked for. And those
  // that ties hold on to on others.
  std::vector<NodeJoint> joints;
  // None unless added. As nodes they are numbered after the figure's.
  std::vector<LooseBall> balls = {};

  // Null: there is none of that joint, or of the root.
  const NodeJoint* SeatOf(JointIndex joint) const;
  int num_nodes() const { return static_cast<int>(nodes.size() + balls.size()); }
  int NodeOfBall(int ball) const { return static_cast<int>(nodes.size()) + ball; }
  bool is_ball(int node) const { return node >= static_cast<int>(nodes.size()); }
};
// Returns, for each node, whether the node is free and nothing at or beyond it has mass. Forces do
// not change the motion of such a node.
std::vector<char> WeightlessNodes(const RegionModel& model);
inline auto MembersOf(const RegionModel& model) {
  const auto& [nodes, R_root, coupling, pin_node, p_pin, root_answers, mass, num_free, num_bodies,
               joints, balls] = model;
  return std::tie(nodes, R_root, coupling, pin_node, p_pin, root_answers, mass, num_free,
                  num_bodies, joints, balls);
}

// One model for each island, in order of their first joint. The root is prescribed where no free
// joint lies between it and the pin; else, and in flight, all free joints are one island. Where
// nothing else holds islands together, ties do.
std::vector<RegionModel> CompileRegionModels(const Figure& figure, const ModelRequest& request);

}  // namespace hazumi
