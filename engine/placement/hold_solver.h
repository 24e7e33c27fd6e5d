#pragma once

// Inverse kinematics of a held joint.

#include <optional>
#include <vector>

#include "engine/figure/figure.h"
#include "engine/spatial/jet.h"
#include "engine/spatial/pose.h"
#include "engine/spatial/types.h"

namespace hazumi {

struct HoldTarget {
  Vec3 position = Vec3::Zero();        // of the held joint's origin in the world [m]
  Mat3 orientation = Mat3::Identity();  // of the body that the held joint sits on
};

struct HoldSolution {
  bool reached = false;
  double distance = 0.0;  // how far the held joint stays from its target [m]; 0 if reached
};

// Finds the angles between the root and a held joint:
//   minimise |q - q_keyed|^2 / 2  subject to  c(q) = 0,
// c being the held joint's position error (and, if asked for, the orientation error of the body it
// sits on). With multipliers l this is  F = (q - q_keyed + J^T l, c) = 0, solved by Newton's method
// from the keyed pose, so that the keyed pose picks the branch. The solution's rates and
// accelerations follow exactly from F = 0 differentiated in time, with q_keyed and the root's pose
// given as jets.
class HoldSolver {
 public:
  HoldSolver(const Figure& figure, GroupIndex held, bool hold_orientation);

  // The joints that are solved, ascending: between root and held joint, fixed hinges left out.
  const std::vector<JointIndex>& joints() const { return solved_; }

  // `q`: all joints of the figure as jets, keyed on entry; the solved ones are replaced.
  HoldSolution Solve(const PoseOf<Jet>& X_WR, const HoldTarget& target, std::vector<Jet>* q) const;

 private:
  struct Newton;

  int num_solved() const { return static_cast<int>(solved_.size()); }
  int num_constraints() const { return hold_orientation_ ? 6 : 3; }
  bool Converge(const PoseOf<double>& X_WR, const HoldTarget& target, Newton* newton) const;
  double LeastDistance(const PoseOf<double>& X_WR, const HoldTarget& target, Newton* newton) const;

  const Figure* figure_;
  JointIndex held_;
  bool hold_orientation_;
  std::vector<JointIndex> chain_;   // root to held joint, the latter's own hinges left out
  std::vector<JointIndex> solved_;
  std::vector<int> row_of_chain_;   // chain index -> row in solved_, or -1
};

}  // namespace hazumi
