#pragma once

// Which forces at given points push a figure as it has to be pushed.

#include <vector>

#include "engine/analysis/lanes/effort_kernels.h"
#include "engine/figure/indices.h"
#include "engine/spatial/lanes/lane_array.h"
#include "engine/spatial/wrench.h"

namespace hazumi {

// A point at which something outside may push the figure.
struct ContactPoint {
  JointIndex joint;             // whose body it is on; invalid: the root's
  Vec3 p = Vec3::Zero();        // [m], world
  Vec3 normal = Vec3::UnitZ();  // unit, from the ground to the figure
  double weight = 1.0;          // how much of it touches, above 0 and up to 1
  bool is_grip = false;         // gives a force of any direction; else one in the friction cone
  int id = 0;                   // the same from frame to frame, ascending in each
};

inline constexpr double kGroundFriction = 0.8;  // coefficient, of the ground and of boxes

// Finds, among all forces in their cones, first those whose sum is nearest to the force needed, of
// these those whose moment is nearest to the moment needed, and of these the ones with the least
// sum of force^2 / weight. contact_forces.cpp has the equations. A call begins near the solution of
// the call before, which saves steps and does not change the solution.
class ContactForceSolver {
 public:
  explicit ContactForceSolver(const EffortKernels& kernels = BestEffortKernels())
      : kernels_(kernels) {}

  // `needed`: force, and moment about `about` [m], which is the centre of mass where the moment is
  // to be the rate of the spin. `forces`: one for each of `points` [N]. Returns what they do not
  // supply, about the same point.
  Wrench Solve(const Wrench& needed, const Vec3& about, const std::vector<ContactPoint>& points,
               double friction, std::vector<Vec3>* forces);

 private:
  using Vec6 = Eigen::Matrix<double, 6, 1>;
  void KeepParts(const std::vector<ContactPoint>& points);

  EffortKernels kernels_;
  LaneArray given_, found_;  // by four contacts and ConeField
  std::vector<int> ids_;     // of the contacts the last time
  // The multipliers of the two calls before, the last one first, about the world's origin, and how
  // many of them there are.
  Vec6 last_[2];
  int num_last_ = 0;
  bool was_met_ = false;  // the last time all that was needed was supplied
};

}  // namespace hazumi
