#pragma once

#include <vector>

#include "engine/dynamics/inverse_dynamics.h"
#include "engine/dynamics/lane_kernels.h"
#include "engine/dynamics/lane_plan.h"
#include "engine/spatial/wrench.h"

namespace hazumi {

// Instructions to compute with. Both give the same bits.
enum class Instructions { kBaseline, kAvx2 };
Instructions BestInstructions();  // of this machine

// Scratch of FigureDynamics: one for each thread that evaluates. Debug builds fill it with NaN.
struct FigureScratch {
  explicit FigureScratch(const LanePlan& plan);

  LaneArray array;         // as LanePlan lays it out
  std::vector<Mat3> R_WB;  // by body, for forces on end links
  double* data() { return array.data(); }
  const double* data() const { return array.data(); }
};

// Inverse dynamics of a whole figure, from angles to torques, O(N).
// The figure is prepared once; an evaluation then allocates nothing.
// For what is needed of single bodies on the way see inverse_dynamics.h.
//
// q [rad], qd [rad/s], qdd [rad/s^2], tau [N m]: one entry a joint; results are not resized.
// `root.a` is the acceleration of the root minus gravity. `ends` may be null.
class FigureDynamics {
 public:
  explicit FigureDynamics(const Figure& figure, Instructions instructions = BestInstructions());

  FigureScratch MakeScratch() const { return FigureScratch(plan_); }

  // T = Dinv(q, qd, qdd, a, Kf, Kn) [Arai (1)], by Newton and Euler.
  void InverseDynamics(const Pose& X_WR, const RootMotion& root, const VecX& q, const VecX& qd,
                       const VecX& qdd, const EndForces* ends, FigureScratch* scratch,
                       VecX* tau) const;

  // What has to push the root for that, at its origin, in world axes: nothing else holds the figure
  // but `ends`. Of the InverseDynamics that the scratch was last used for, with the same root.
  Wrench RootWrench(const Pose& X_WR, const RootMotion& root, const FigureScratch& scratch) const;

 private:
  void SetRoot(const Pose& X_WR, const RootMotion& root, FigureScratch* scratch) const;
  void SubtractEndForces(const Pose& X_WR, const EndForces& ends, FigureScratch* scratch) const;
  Mat3 RotationFromParent(const LaneBody& body, const double* scratch) const;

  RigidInertia root_inertia_;
  LanePlan plan_;
  LaneKernels kernels_;
  std::vector<int> end_bodies_;  // in the order of EndJoints
};

}  // namespace hazumi
