#pragma once

// Which forces at given points push a figure as it has to be pushed.

#include <vector>

#include "engine/analysis/lanes/effort_kernels.h"
#include "engine/figure/indices.h"
#include "engine/spatial/lanes/lane_array.h"
#include "engine/spatial/wrench.h"

namespace hazumi {

// Point at which the scene may exert a contact force on the figure.
struct ContactPoint {
  JointIndex joint;             // whose body it is on; invalid: the root's
  Vec3 p = Vec3::Zero();        // [m], world
  Vec3 normal = Vec3::UnitZ();  // unit, from the ground to the figure
  double weight = 1.0;          // how much of it touches, above 0 and up to 1
  bool is_grip = false;         // can exert any force; else limited to the friction cone
  int id = 0;                   // the same from frame to frame, ascending in each
};

inline constexpr double kGroundFriction = 0.8;  // coefficient, of the ground and of boxes

// Finds the contact forces within their cones. The forces minimize the residual force, then the
// residual moment, then the sum of force^2 / weight. contact_forces.cpp has the equations. Each
// call starts near the solution of the previous call, which saves iterations and does not change
// the solution.
class ContactForceSolver {
 public:
  explicit ContactForceSolver(const EffortKernels& kernels = BestEffortKernels())
      : kernels_(kernels) {}

  // `needed`: required force, and moment about `about` [m], the centre of mass where the moment is
  // the rate of angular momentum. `forces`: one for each of `points` [N]. Returns the residual
  // wrench about the same point.
  Wrench Solve(const Wrench& needed, const Vec3& about, const std::vector<ContactPoint>& points,
               double friction, std::vector<Vec3>* forces);

 private:
  using Vec6 = Eigen::Matrix<double, 6, 1>;
  void KeepParts(const std::vector<ContactPoint>& points);

  EffortKernels kernels_;
  LaneArray given_, found_;  // by four contacts and ConeField
  std::vector<int> ids_;     // of the contacts the last time
  // Multipliers of the previous two calls about the world's origin, the latest first, and their
  // number.
  Vec6 last_[2];
  int num_last_ = 0;
  bool was_met_ = false;  // the last time all that was needed was supplied
};

}  // namespace hazumi
