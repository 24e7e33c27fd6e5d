#pragma once

#include <vector>

#include "engine/figure/figure.h"
#include "engine/region/equations/tree_equations.h"

namespace hazumi::test {

// A figure all of whose joints are a region, on a root that does not move: how torques accelerate
// it, by the equations that a bake solves.
class FreeFigure {
 public:
  // `base`: the root's acceleration minus gravity, in the root's axes [m/s^2].
  FreeFigure(const Figure& figure, const Vec3& base);

  // By joint: angles [rad], rates [rad/s] and torques [N m] to accelerations [rad/s^2].
  void Accelerate(const VecX& q, const VecX& qd, const VecX& tau, VecX* qdd);

 private:
  // Joints that feel each other.
  struct Island {
    explicit Island(RegionModel of);
    void Accelerate(const DrivenMotion& still, const small::V3& base, const VecX& q, const VecX& qd,
                    const VecX& tau, VecX* qdd);

    RegionModel model;
    RegionLayout layout;
    NodeKinematics kinematics;
    TreeEquations equations;
    VecX q, qd, tau, x;  // by free hinge
  };

  DrivenMotion still_;
  small::V3 base_;
  std::vector<Island> islands_;
};

}  // namespace hazumi::test
