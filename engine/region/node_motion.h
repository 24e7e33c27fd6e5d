#pragma once

#include <array>
#include <limits>
#include <tuple>
#include <vector>

#include "engine/region/driven_curve.h"
#include "engine/region/region_layout.h"
#include "engine/region/sines_and_cosines.h"
#include "engine/spatial/small.h"

namespace hazumi {

// What a spring reads over time besides the angle that it pulls to, of one hinge.
struct SpringCurves {
  DrivenCurve frequency;  // [Hz]
  DrivenCurve share;      // of what muscles can give
  // What is added to its pull: about the hinge [N m], and of a ball joint along the axis of its
  // frame that has the hinge's number.
  DrivenCurve torque, moment;
};
inline auto MembersOf(const SpringCurves& curves) {
  const auto& [frequency, share, torque, moment] = curves;
  return std::tie(frequency, share, torque, moment);
}

// What moves from outside in one smooth stretch of time. By Coordinate: read where driven.
struct DrivenMotion {
  std::vector<DrivenCurve> angles;
  std::array<DrivenCurve, 3> root_position;  // read where the root's position is prescribed
  // What drives of free hinges read: torques [N m], or the angles that springs pull to [rad]. None
  // if there are no drives.
  std::vector<DrivenCurve> drives = {};
  std::vector<SpringCurves> springs = {};  // likewise; none if no spring reads any of it
  // Time up to which the polynomials hold, although a shorter motion may be requested [s]. Steps
  // extend up to here and are cut at the requested end, so that no step depends on that end.
  // Default: steps end at the requested end.
  double holds_until = -std::numeric_limits<double>::infinity();
  // Largest length of a step that may be cut [s].
  static constexpr double kLongestCut = 0.15;
  bool may_be_cut() const { return holds_until > -std::numeric_limits<double>::infinity(); }
};
inline auto MembersOf(const DrivenMotion& driven) {
  const auto& [angles, root_position, drives, springs, holds_until] = driven;
  return std::tie(angles, root_position, drives, springs, holds_until);
}

// One node at one instant. World axes.
struct NodeMotion {
  small::M3 R;                    // world from node
  small::V3 p, r;                 // its origin: from the root's, from its parent's [m]
  small::V3 w, alpha, a;          // with the accelerations of free hinges zero
  std::array<small::V3, 3> axis;  // of its dofs, unit
  // What it asks of the joint that carries it, about its origin; and its inertia, about the same.
  small::V3 f, n;
  double m = 0.0;
  small::V3 h;  // mass times CoM
  small::S3 I;
};

// Places and moves the nodes of a model.
class NodeKinematics {
 public:
  explicit NodeKinematics(const RegionModel& model);

  // Nodes [first, last) from their parents on. `positions`, `velocities`: of the free joints.
  void Move(const RegionLayout& layout, const DrivenMotion& driven, double t,
            const double* positions, const double* velocities, int first, int last);
  // After Move: adds what accelerations x of the free joints do to the nodes from `first` on.
  void Accelerate(const RegionLayout& layout, const double* x, int first);
  // After it, of all nodes and forces since SetOwnForces: what the dynamic ones ask for together.
  small::V3 AskedForce() const;
  // Forces and inertias of the dynamic nodes themselves, everything being accelerated by `base`
  // [m/s^2] on top.
  void SetOwnForces(const small::V3& base);
  // After it: something pulls at a node with a force [N], r from its origin [m], or turns it with a
  // torque [N m].
  void AddForce(int node, const small::V3& r, const small::V3& force);
  void AddTorque(int node, const small::V3& torque);
  // A moment on a node against the one that carries it [N m].
  void AddJointMoment(int node, const small::V3& moment);
  // Of AddForce, of all nodes since SetOwnForces or ClearForces [N].
  const small::V3& added_force() const { return added_force_; }
  // As if nothing asked for a force.
  void ClearForces();

  std::vector<NodeMotion>& motion() { return motion_; }
  const std::vector<NodeMotion>& motion() const { return motion_; }
  int size() const { return static_cast<int>(nodes_.size()); }  // of the figure's
  bool is_ball(int node) const { return node >= size(); }

 private:
  struct Node {
    int parent;
    small::V3 p_P;
    int num_hinges;
    std::array<NodeHinge, 3> hinges;
    std::array<small::V3, 3> axis;  // of the hinges
    bool is_dynamic, is_massless;
    double mass;
    small::V3 h;  // mass times CoM, in the node's frame
    small::S3 I;  // about its origin
    bool is_diagonal;
  };
  // What the hinges of a node change, on the way outwards.
  struct Frame {
    small::M3 R;
    small::V3 w, alpha;
  };

  void TurnDriven(const Node& node, const DrivenMotion& driven, double t, Frame* frame) const;
  void TurnHinges(const Node& node, const RegionLayout::Node& layout, const double* velocities,
                  Frame* frame, NodeMotion* own) const;
  static void TurnBall(const RegionLayout::Node& layout, const double* positions,
                       const double* velocities, Frame* frame, NodeMotion* own);

  std::vector<small::V3> dalpha_, da_;  // scratch
  small::V3 added_force_;
  small::M3 R_root_;
  std::vector<Node> nodes_;
  std::vector<NodeMotion> motion_;
  SinesAndCosines turns_;  // of the free hinges
};

}  // namespace hazumi
