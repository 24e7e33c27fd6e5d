#pragma once

// Which forces at given points push a figure as it has to be pushed.

#include <vector>

#include "engine/dynamics/figure_dynamics.h"
#include "engine/figure/indices.h"

namespace hazumi {

// Where something outside pushes the figure.
struct ContactPoint {
  JointIndex joint;             // whose body it is on; invalid: the root's
  Vec3 p = Vec3::Zero();        // [m], world
  Vec3 normal = Vec3::UnitZ();  // unit, from the ground to the figure
  double weight = 1.0;          // how much of it touches, above 0 and up to 1
  bool is_pin = false;          // gives any force; else one in the friction cone
  bool has_moment = false;      // of a pin: any moment too
};

struct ContactForce {
  Vec3 force = Vec3::Zero();   // on the figure, at its point [N]
  Vec3 moment = Vec3::Zero();  // of a pin [N m]
};

inline constexpr double kGroundFriction = 0.8;  // coefficient, of the ground and of boxes

// Of all forces that are in their cones, and together as near to `needed` as such forces come,
// those with the least sum of force^2 / weight. contact_forces.cpp has the equations.
class ContactForceSolver {
 public:
  // `needed`: force, and moment about `about` [m]. `forces` goes with `points`. Returns what they
  // do not supply, about the same point.
  Wrench Solve(const Wrench& needed, const Vec3& about, const std::vector<ContactPoint>& points,
               double friction, std::vector<ContactForce>* forces);

 private:
  using Vec6 = Eigen::Matrix<double, 6, 1>;
  using Mat6 = Eigen::Matrix<double, 6, 6>;

  void Begin(const Vec3& middle, const std::vector<ContactPoint>& points, double softness);
  // At y: what the points supply, its derivative, and the function that it is the gradient of.
  void Evaluate(const Vec6& y, const std::vector<ContactPoint>& points, double friction);
  double Merit(const Vec6& y, const Vec6& start, const Vec6& needed) const;
  bool SolveWithoutCones(const Vec6& needed, const std::vector<ContactPoint>& points,
                         double friction, Vec6* y);
  void Approach(const Vec6& needed, const std::vector<ContactPoint>& points, double friction,
                const Vec6& start, Vec6* y);

  std::vector<Vec3> arms_;  // by point, from the middle, in units of kArm
  double softness_ = 0.0;
  Mat6 whole_;  // the derivative where all forces are inside their cones; lower halves
  Vec6 supplied_;
  Mat6 slope_;
  double potential_ = 0.0;
  bool is_cut_ = false;  // a force is not inside its cone
  bool has_guess_ = false;
  Vec6 guess_;  // the last answer
  Vec3 guess_middle_;
};

}  // namespace hazumi
