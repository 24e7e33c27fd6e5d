#pragma once

#include "engine/region/equations/articulated_bodies.h"
#include "engine/region/equations/dense_equations.h"

namespace hazumi {

// The equations of motion of a model without their matrix, by articulated bodies, in O(n). A pin
// that the root answers is kept by forces: the figure flies, pushed there as hard as keeps it in
// place.
class TreeEquations {
 public:
  explicit TreeEquations(const RegionModel& model);

  // x: accelerations by dof of the layout, for nodes that move and ask for forces as in `motion`.
  // A direction that moves no mass gets 0.
  void Solve(const RegionLayout& layout, const std::vector<NodeMotion>& motion, double* x);

  // After Solve: what pushes do, unless a pin has to be kept.
  ArticulatedBodies& bodies() { return bodies_; }
  const ArticulatedBodies& bodies() const { return bodies_; }

  // M and b of some hinges alone, k of them, with the others following freely, in O(k n + k^3).
  // `layout` has no balls.
  void AssembleSome(const RegionLayout& layout, const std::vector<NodeMotion>& motion,
                    const std::vector<int>& hinges);
  const IslandEquations& some() const { return some_; }
  // After it: how the rates of all free hinges jump where those hinges get impulses [N m s], and
  // where a pin that moved with v_pin [m/s] is stopped.
  VecX JumpOf(const VecX& impulses) const { return responses_ * impulses; }
  VecX JumpOfPin(const RegionLayout& layout, const std::vector<NodeMotion>& motion,
                 const Vec3& v_pin);

 private:
  small::V3 ArmOfPin(const std::vector<NodeMotion>& motion) const {
    return motion[pin_node_].R * p_pin_;
  }
  void PushPin(const RegionLayout& layout, const std::vector<NodeMotion>& motion);
  void KeepPin(const small::V3& a, int size, double* x) const;

  ArticulatedBodies bodies_;
  bool is_on_pin_;
  int pin_node_;
  small::V3 p_pin_;
  int num_free_;
  // Of unit forces on the pin: accelerations of the free joints and of the pin.
  Eigen::MatrixX3d pushed_;
  Mat3 pin_pushed_;
  MatX responses_;  // of the free hinges to unit torques
  IslandEquations some_;
};

}  // namespace hazumi
