#pragma once

// Inverse kinematics of a held joint.

#include <Eigen/LU>
#include <tuple>
#include <vector>

#include "engine/matrix/pivoted_lu.h"
#include "engine/placement/hold_chain.h"
#include "engine/timeline/placement_span.h"

namespace hazumi {

struct HoldTarget {
  Vec3 position = Vec3::Zero();         // of the held joint's origin in the world [m]
  Mat3 orientation = Mat3::Identity();  // of the body that the held joint sits on
  bool operator==(const HoldTarget&) const = default;
};
inline auto MembersOf(const HoldTarget& target) {
  const auto& [position, orientation] = target;
  return std::tie(position, orientation);
}

struct HoldSolution {
  bool reached = false;
  // How far the held joint stays from its target [m], its orientation as good as it gets; 0 if
  // reached, or with a tolerance at most about that.
  double distance = 0.0;
};

// Finds the angles of the joints that a hold moves:
//   minimise |q - q_keyed|^2 / 2  subject to  c(q) = 0,
// c being the held joint's position error (and, if asked for, the orientation error of the body it
// sits on). With multipliers l this is  F = (q - q_keyed + J^T l, c) = 0, solved by Newton's method
// from the keyed pose, so that the keyed pose picks the branch. The solution's rates and
// accelerations follow exactly from F = 0 differentiated in time, with q_keyed and the root's pose
// given as jets. The limits of the hinges are no constraints, but of two poses that are about as
// near to the keyed one, as those of a straight knee are, the one that is less far beyond them is
// taken. The result depends on the arguments alone, not on what was solved before.
class HoldSolver {
 public:
  // `figure` must outlive the solver.
  HoldSolver(const Figure& figure, const IkHold& hold);

  // The joints that are solved, ascending: those within the hold's reach, fixed hinges left out.
  const std::vector<JointIndex>& joints() const { return chain_.unknowns(); }

  // `q`: all joints of the figure as jets, keyed on entry; the solved ones are replaced if the
  // target is reached. One that is out of reach by no more than `tolerance` [m] is reached: in its
  // place the nearest point is held that is within reach by a micrometre or ten.
  HoldSolution Solve(const PoseOf<Jet>& X_WR, const HoldTarget& target, std::vector<Jet>* q,
                     double tolerance = 0.0);

  // Those of `q` that the solution depends on.
  std::vector<Jet> ChainOf(const std::vector<Jet>& q) const;

 private:
  struct Problem {
    const PoseOf<Jet>& X_WR;
    const HoldTarget& target;
    const std::vector<Jet>& q;
  };
  enum class Hessian { kFull, kWithoutChain };

  HoldSolution SolveExactly(const Problem& problem);
  bool SolveBeside(const PoseOf<Jet>& X_WR, const HoldTarget& target, const std::vector<Jet>& q);
  bool Converge(const Problem& problem, int iterations, Hessian hessian);
  double Excess() const;
  void PreferTheLimits(const Problem& problem);
  bool ConvergeFromAfar(const Problem& problem, double* distance);
  void StartFrom(int start);
  double LeastDistance(const Problem& problem);
  void SetDerivative(Hessian hessian);
  void Factor();
  VecX& SolveLinear(const VecX& right_side);
  void FindRates(const Problem& problem);

  HoldChain chain_;
  int n_, m_;  // unknown angles, constraints

  // Scratch. The unknowns x are angles and multipliers.
  ChainPose<double> pose_;
  ChainPose<Jet> pose_jet_;
  VecX keyed_, x_, F_, step_;
  VecXOf<Jet> keyed_jet_, x_jet_, F_jet_;
  MatX K_;  // dF/dx
  PivotedLu lu_;
  Eigen::FullPivLU<MatX> lu_singular_;
  bool singular_ = false;
  // The point nearest to a target out of reach, and where the chain begins there [m].
  Vec3 nearest_ = Vec3::Zero(), chain_start_ = Vec3::Zero();
};

}  // namespace hazumi
