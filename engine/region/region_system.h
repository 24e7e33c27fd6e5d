#pragma once

#include <vector>

#include "engine/dynamics/inverse_dynamics.h"
#include "engine/dynamics/workspace.h"

namespace hazumi {

// What the rest of the world lets the root do while some joints are free. [METHOD 2.2, Arai 3]
enum class RootCoupling {
  kPrescribed,  // the root moves as its curves say
  kPinned,      // a joint's origin stays in place; the pin's force does no work
  kFlight,      // no outer force but gravity: the root's translation answers the free joints
};

// State of the whole figure at the start of a step.
struct PassiveState {
  Pose X_WR;
  RootMotion root;  // kPinned and kFlight: `a` is not read
  VecX q, qd;       // all joints [rad, rad/s]
  VecX qdd;         // [rad/s^2]; read for the joints that are not free
};

// The free joints' equation of motion  M y'' = -b  in the joints of one or more dynamics regions,
// with everything else prescribed and the root's translation eliminated.
//
// With x = (root translation, free joints) and x'' = P y'' + c:  M = P^T H P, b = P^T (B + H c).
//   kPrescribed  P = (0, 1)           c = (a, 0)
//   kPinned      P = (-J, 1)          c = (acceleration that keeps the pin still at y'' = 0, 0)
//   kFlight      eliminates the root's rows by their Schur complement
// H and B by unit accelerations and the bias vector [Arai (3), (4)]; J = pin's Jacobian.
class RegionSystem {
 public:
  // `free` ascending. The figure must outlive the system.
  RegionSystem(const Figure& figure, std::vector<JointIndex> free);

  // Fills M and b for this state. `pin` is read for kPinned, gravity is along -z [m/s^2].
  void Evaluate(const PassiveState& state, RootCoupling coupling, JointIndex pin, double gravity,
                DynamicsWorkspace* ws);

  const std::vector<JointIndex>& free() const { return free_; }
  int size() const { return static_cast<int>(free_.size()); }
  const MatX& M() const { return M_; }  // k x k [kg m^2]
  const VecX& b() const { return b_; }  // k [N m]

  // Rates of the free joints after the root's velocity was forced from that of `state` to a pin at
  // rest [METHOD 5.7]: M y' = P^T H (x' - c'), for a state whose root moved with state.root.
  // Returns false if M is singular.
  bool RatesAfterPinning(const PassiveState& state, JointIndex pin, DynamicsWorkspace* ws,
                         VecX* rates);

 private:
  void ComputeInertia(DynamicsWorkspace* ws);
  void ComputeBias(const PassiveState& state, const Vec3& root_acceleration, DynamicsWorkspace* ws);
  void ProjectOnPin(JointIndex pin, const DynamicsWorkspace& ws);
  void EliminateRoot();

  const Figure& figure_;
  std::vector<JointIndex> free_;
  MatX M_;
  VecX b_;
  Eigen::Matrix3Xd H_root_;     // 3 x k: force on the root for unit accelerations [kg m]
  Eigen::Matrix3Xd J_;          // 3 x k: pin's Jacobian [m]
  Vec3 f_root_ = Vec3::Zero();  // force on the root at y'' = 0 [N]
  VecX prescribed_qdd_;         // scratch, N
};

}  // namespace hazumi
