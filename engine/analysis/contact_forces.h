#pragma once

// Which forces at given points push a figure as it has to be pushed.

#include <vector>

#include "engine/analysis/lanes/effort_kernels.h"
#include "engine/figure/indices.h"
#include "engine/spatial/lanes/lane_array.h"
#include "engine/spatial/wrench.h"

namespace hazumi {

// Where something outside pushes the figure.
struct ContactPoint {
  JointIndex joint;             // whose body it is on; invalid: the root's
  Vec3 p = Vec3::Zero();        // [m], world
  Vec3 normal = Vec3::UnitZ();  // unit, from the ground to the figure
  double weight = 1.0;          // how much of it touches, above 0 and up to 1
  bool is_pin = false;          // gives any force; else one in the friction cone
  bool has_moment = false;      // of a pin: any moment too
  int id = 0;                   // the same from frame to frame, ascending in each
};

struct ContactForce {
  Vec3 force = Vec3::Zero();   // on the figure, at its point [N]
  Vec3 moment = Vec3::Zero();  // of a pin [N m]
};

inline constexpr double kGroundFriction = 0.8;  // coefficient, of the ground and of boxes

// Of all forces that are in their cones, and together as near to `needed` as such forces come,
// those with the least sum of force^2 / weight. contact_forces.cpp has the equations. Asked frame
// by frame it begins near the answer, which changes the way, not where it leads.
class ContactForceSolver {
 public:
  explicit ContactForceSolver(const EffortKernels& kernels = BestEffortKernels())
      : kernels_(kernels) {}

  // `needed`: force, and moment about `about` [m]. `forces` goes with `points`. Returns what they
  // do not supply, about the same point.
  Wrench Solve(const Wrench& needed, const Vec3& about, const std::vector<ContactPoint>& points,
               double friction, std::vector<ContactForce>* forces);

 private:
  using Vec6 = Eigen::Matrix<double, 6, 1>;
  void KeepParts(const std::vector<ContactPoint>& points);

  EffortKernels kernels_;
  LaneArray given_, found_;  // by four contacts and ConeField
  std::vector<int> ids_;     // of the contacts the last time
  // The answers before the next one, the last first, about the world's origin; how many there are.
  Vec6 last_[2];
  int num_last_ = 0;
  bool was_met_ = false;  // the last time all that was needed was supplied
};

}  // namespace hazumi
