#pragma once

#include <array>
#include <vector>

#include "engine/passive/driven_curve.h"
#include "engine/passive/hinge_triple.h"
#include "engine/passive/region_model.h"

namespace hazumi {

// A hinge that a region frees.
struct FreeHinge {
  Coordinate coordinate;
  int node, slot;  // which hinge of which node
};

// What moves from outside in one smooth stretch of time. By Coordinate: read where driven.
struct DrivenMotion {
  std::vector<DrivenCurve> angles;
  std::array<DrivenCurve, 3> root_position;  // read where the root's position is prescribed
};

// The equations of motion of a region model in continuous time [METHOD 2]:
//   M(q) x = -b(q, v, t),   v' = x - C v
// with v the angular velocities of ball joints (in the body's frame) and the rates of other free
// hinges, and C the friction rates: friction is a rule for accelerations, not a torque.
//
// A state y is positions followed by velocities. Which joints are balls and which hinges are locked
// (on their stops, at rest) is a matter of the layout; a joint of three hinges one of which is
// locked goes on as two hinges. World axes throughout; points from the root's origin.
class RegionDynamics {
 public:
  // `friction`: by free hinge, rates [1/s]. `gravity`: along -z [m/s^2].
  RegionDynamics(RegionModel model, VecX friction, double gravity);

  const RegionModel& model() const { return model_; }
  const std::vector<FreeHinge>& hinges() const { return hinges_; }
  int num_hinges() const { return static_cast<int>(hinges_.size()); }

  // The curves must outlive their use.
  void SetDriven(const DrivenMotion* driven) { driven_ = driven; }

  // Locks some free hinges at these angles [rad]; by free hinge.
  void SetLocked(const std::vector<char>& locked, const VecX& angles);
  int num_positions() const { return layout_.num_positions; }
  int num_velocities() const { return layout_.num_dofs; }
  int state_size() const { return num_positions() + num_velocities(); }

  // Angles and rates of the free hinges as a state of the present layout.
  void Pack(const VecX& q, const VecX& qd, double* y) const;
  // And back. `q` on entry: angles nearby, which pick the branch and the turn of ball joints.
  // `lower`, `upper`: limits, as HingeTriple::Angles.
  void Unpack(const double* y, const VecX& lower, const VecX& upper, VecX* q, VecX* qd) const;
  bool is_quaternion(int position) const { return layout_.is_quaternion[position]; }

  // dy/dt at time t [s]. Counts as one evaluation.
  void Derivative(double t, const double* y, double* dy);

  // M (k x k) and b (k) with the rates of all free hinges, locked or not, as velocities: what stops
  // press and what impacts do.
  void AssembleHinges(double t, const VecX& q, const VecX& qd);
  const MatX& M() const { return M_; }
  const VecX& b() const { return b_; }

  // After AssembleHinges: the blow on the free hinges [N m s] when the root's velocity jumps so
  // that a pin, which moved with v_pin [m/s], stands still. [METHOD 2, "kicks"]
  void PinBlow(const Vec3& v_pin, VecX* blow) const;

  // By free hinge: how far two poses are apart [rad]; for the hinges of a ball joint, the angle
  // between the two orientations.
  void Distances(const VecX& q, const VecX& other, VecX* distances) const;

  long evaluations() const { return evaluations_; }

 private:
  enum class NodeKind : char { kStill, kDriven, kHinges, kBall };
  struct NodeLayout {
    NodeKind kind = NodeKind::kStill;
    int position = 0;  // of its first in the positions
    int dof = 0;       // of its first in the velocities
    int num_dofs = 0;
    int first_hinge = 0;            // in hinges_
    std::array<bool, 3> locked{};   // by hinge of the node
    std::array<double, 3> angle{};  // of the locked ones
  };
  struct Layout {
    std::vector<NodeLayout> nodes;
    std::vector<char> is_quaternion;  // by position
    int num_positions = 0, num_dofs = 0;
  };
  struct NodeMotion {
    Mat3 R;                    // world from node
    Vec3 p;                    // [m]
    Vec3 w, alpha, a;          // with the accelerations of free hinges zero
    std::array<Vec3, 3> axis;  // of its dofs
    Vec3 f, n;                 // force and moment about p that the motion asks for, of all beyond
    double m;                  // composite of all beyond: mass, mass times CoM, inertia about p
    Vec3 h;
    Mat3 I;
  };

  Layout MakeLayout(const std::vector<char>& locked, const VecX& angles, bool balls) const;
  void Move(double t, const Layout& layout, const double* positions, const double* velocities);
  void MoveNode(double t, int i, const NodeLayout& layout, const double* positions,
                const double* velocities);
  void TurnDriven(double t, const ModelNode& node, NodeMotion* motion) const;
  void TurnHinges(const ModelNode& node, const NodeLayout& layout, const double* positions,
                  const double* velocities, NodeMotion* motion) const;
  void TurnBall(const NodeLayout& layout, const double* positions, const double* velocities,
                NodeMotion* motion) const;
  Vec3 BaseAcceleration(double t) const;
  void StartForces(double t);
  void Assemble(double t, const Layout& layout);
  void AssembleColumn(const Layout& layout, int node, int dof, const Vec3& axis);
  void PassToParent(int node);
  void Couple(const Layout& layout);
  void ProjectOnPin(const Layout& layout);
  void Damp(const double* y, double* x);
  void DampBall(int node, const NodeLayout& layout, const double* quaternion, const double* w,
                double* x) const;
  void AnswerDamping(const Eigen::Ref<const VecX>& damping);

  RegionModel model_;
  std::vector<FreeHinge> hinges_;
  std::vector<HingeTriple> triples_;  // of ball nodes
  std::vector<int> triple_of_;        // by node, -1: none
  VecX friction_;
  bool has_friction_ = false;
  double gravity_;
  const DrivenMotion* driven_ = nullptr;
  Layout layout_, hinge_layout_;
  std::vector<NodeMotion> motion_;
  MatX M_, L_;
  VecX b_, x_, damping_, scratch_;
  Eigen::Matrix3Xd F_, J_;  // force on the root and motion of the pin for unit accelerations
  long evaluations_ = 0;
};

}  // namespace hazumi
