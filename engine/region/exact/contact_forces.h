#pragma once

#include <vector>

#include "engine/region/exact/contact_problem.h"
#include "engine/region/region_dynamics.h"

namespace hazumi {

// What contacts, limits and constraints do to the free hinges of an island together: impacts, and
// what rests, as one problem of forces in cones. `side`, `sticks`, `fixed`: by free hinge, as
// LimitSolver has them. [METHOD 12]
class ContactForces {
 public:
  // `dynamics` must outlive it.
  explicit ContactForces(RegionDynamics* dynamics);

  // How near counts as touching [m], and how slow as at rest [m/s].
  void SetTouch(double gap, double speed) {
    touch_ = gap;
    rest_speed_ = speed;
  }
  // Pairs that touch at these angles; the others are open from now on. False: none.
  bool FindTouching(double t, const HingeState& state);
  // Whether another pair hits so soon before or after these that a solution cannot tell whether it
  // hits together with them, which makes another motion.
  bool is_order_unsure() const { return is_order_unsure_; }
  // An impact of everything that touches, inelastic except where capsules have a restitution, and
  // of a pin that is stopped.
  void Impact(double t, const std::vector<int>& side, const std::vector<char>& sticks,
              HingeState* state);
  // Whether that has a solution: friction may wedge what touches, so that no push is enough.
  bool has_solved_impact() const { return has_solved_impact_; }
  // Work of the impact [J], the part of limits, and the pairs that touched down with an impulse.
  double work() const { return work_; }
  double limit_work() const { return limit_work_; }
  const std::vector<int>& struck() const { return struck_; }
  // Impulses of the rows [N s, N m s].
  const VecX& row_impulses() const { return l_; }
  // Then: which hinges at a limit stay there, and which pairs stay closed, sticking or sliding.
  void Rest(double t, const HingeState& state, const std::vector<int>& side,
            const std::vector<char>& fixed, std::vector<char>* held);
  // What limits give then, by free hinge [N m].
  const VecX& T() const { return T_; }

 private:
  void Close(int pair, const TouchPoint& point, bool may_slide);
  bool Solve();
  void Bounce(const VecX& came);
  void ListStruck(const VecX& came);
  VecX ImpulsesOfBounce(const VecX& came) const;
  bool IsFelt(Eigen::Index row) const;
  void SetModes();

  RegionDynamics* dynamics_;
  double touch_ = 0.0, rest_speed_ = 0.0;
  bool is_order_unsure_ = false, has_solved_impact_ = true;
  std::vector<int> touching_, struck_;  // indices of pairs
  double work_ = 0.0, limit_work_ = 0.0;
  ContactProblem problem_;
  VecX l_, T_;
};

}  // namespace hazumi
