#pragma once

#include <vector>

#include "engine/region/node_motion.h"

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
  // direction that moves no mass gets 0. The root's translation answers as in flight, or not.
  void Solve(const RegionLayout& layout, const std::vector<NodeMotion>& motion, double* x);
  // After Solve, with the same motion: x of nothing but a force [N] on a point of a dynamic node,
  // r from its origin [m].
  void Push(const RegionLayout& layout, const std::vector<NodeMotion>& motion, int node,
            const small::V3& r, const small::V3& force, double* x);
  // The same of nothing but a torque of 1 N m about a free hinge, no part of a ball.
  void Twist(const RegionLayout& layout, const std::vector<NodeMotion>& motion, int node, int dof,
             double* x);
  // The same of nothing but an acceleration of all that carries the bodies [m/s^2].
  void Shake(const RegionLayout& layout, const std::vector<NodeMotion>& motion,
             const small::V3& acceleration, double* x);
  // After Solve, with the same motion; before the others.
  void FactorJoints(const RegionLayout& layout, const std::vector<NodeMotion>& motion);
  // After it: adds to `half` half of what such a push of size 1 does, or a torque where it `turns`:
  // with M = R R^T and J what it does to the unknowns, R^-1 J^T. The product of two halves is what
  // one push does to where the other one is. Unknowns: the root's translation, if it flies, then
  // the dofs.
  void AddHalf(const RegionLayout& layout, const std::vector<NodeMotion>& motion, int node,
               const small::V3& r, const small::V3& force, bool turns, double* half) const;
  int num_root() const { return root_flies_ ? 3 : 0; }
  // The other half: x of pushes, by the sum of their halves.
  void FinishHalf(const RegionLayout& layout, const std::vector<NodeMotion>& motion,
                  const double* half, double* x);
  // Copies the factors of the joint of a dynamic node: [I; H^T] s, zero where nothing carries the
  // joint, and D^-1 (below). Requires Solve.
  void CopyJoint(int node, std::array<small::V3, 3>* UI, std::array<small::V3, 3>* UF,
                 small::S3* D_inverse) const;
  // The root's acceleration for a unit force on it; 0 where it does not fly.
  small::S3 RootResponse() const;
  // What the accelerations found last do to a point of a dynamic node, r from its origin [m/s^2].
  small::V3 AccelerationAt(int node, const small::V3& r) const;

 private:
  // L of three directions, with those empty that move no mass: inverse pivots, and what is below.
  struct Triangle {
    double inverse_a, inverse_b, inverse_c, ab, ac, bc;
  };
  static Triangle TriangleOf(const small::S3& D, const small::S3& D_inverse);
  static small::V3 SolveLower(const Triangle& L, const small::V3& v);  // L^-1 v
  static small::V3 SolveUpper(const Triangle& L, const small::V3& v);  // L^-T v
  struct Body {
    small::S3 I;
    small::M3 H;
    small::S3 M;
    small::V3 n, f;
    // Of the eliminated directions: [I; H^T] s, D^-1 with D = s^T I s, and what u = -s.n asks for.
    std::array<small::V3, 3> UI, UF;
    small::S3 D_inverse;
    small::V3 y;
    // A ball joint's: D^-1 = I^-1, K = I^-1 H, and y = -I^-1 n, in world axes.
    bool is_ball = false;
    small::M3 K;
    small::V3 dalpha, da;
    Triangle L;  // D = L L^T
  };

  void Begin(const std::vector<NodeMotion>& motion);
  template <int kDofs>
  void Eliminate(int i, const NodeMotion& motion);
  void EliminateBall(int i, const NodeMotion& motion);
  template <int kDofs, bool kIsBase>
  void SolveJoint(const NodeMotion& motion, Body* body) const;
  template <int kDofs>
  void Reduce(Body* body) const;
  template <bool kIsFreeOfMoment>
  void PassToParent(int i, const small::V3& r);
  void Pass(const RegionLayout& layout, const std::vector<NodeMotion>& motion, double* x);
  void PassPush(int i, const RegionLayout& layout, const NodeMotion& motion);
  void Distribute(const RegionLayout& layout, const std::vector<NodeMotion>& motion, double* x);
  void MoveWithParent(int i, const small::V3& r);
  template <int kDofs>
  void Accelerate(int i, const NodeMotion& motion, double* x);
  void AccelerateBall(int i, const NodeMotion& motion, double* x);

  bool root_flies_;
  std::vector<int> parents_;   // by node; -1 where nothing dynamic carries it
  std::vector<char> is_base_;  // moves as it is told: nothing carries it, and the root does not fly
  std::vector<char> is_dynamic_;
  std::vector<Body> bodies_;
  Triangle L_root_;  // of M
  int twisted_node_ = -1, twisted_dof_ = 0;
};

}  // namespace hazumi
