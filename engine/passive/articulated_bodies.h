#pragma once

#include <vector>

#include "engine/passive/node_motion.h"

namespace hazumi {

// Accelerations of the free joints of a model by articulated bodies [Featherstone 2008, 7.3], in
// O(nodes). What a node asks of the joint that carries it, for deviations (dalpha, da) of its
// parent from the motion with all free accelerations zero, is
//   n = I dalpha + H da + n0,   f = H^T dalpha + M da + f0
// about the node's origin; the torque-free directions are eliminated joint by joint, a ball joint
// at once.
class ArticulatedBodies {
 public:
  explicit ArticulatedBodies(const RegionModel& model);

  // x: accelerations by dof of the layout, for nodes that move and weigh as in `motion`. A
  // direction that moves no mass gets 0. `root_flies`: the root's translation answers freely.
  void Solve(const RegionLayout& layout, const std::vector<NodeMotion>& motion, bool root_flies,
             double* x);

 private:
  struct Body {
    small::S3 I;
    small::M3 H;
    small::S3 M;
    small::V3 n, f;
    // Of the eliminated directions: [I; H^T] s, D^-1 with D = s^T I s, and what u = -s.n asks for.
    std::array<small::V3, 3> UI, UF;
    small::S3 D_inverse;
    small::V3 y;
    small::V3 dalpha, da;
  };

  template <int kDofs>
  void Eliminate(int i, const NodeMotion& motion, bool root_flies);
  template <int kDofs>
  void SolveJoint(const NodeMotion& motion, Body* body) const;
  template <int kDofs>
  void Reduce(Body* body) const;
  template <bool kIsFreeOfMoment>
  void PassToParent(const small::V3& r, const Body& from, Body* to) const;
  void Accelerate(const RegionLayout::Node& layout, const NodeMotion& motion, Body* body,
                  double* x) const;

  std::vector<int> parents_;  // by node; -1 where nothing dynamic carries it
  std::vector<char> is_dynamic_;
  std::vector<Body> bodies_;
};

}  // namespace hazumi
