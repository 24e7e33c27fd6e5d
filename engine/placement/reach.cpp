#include "engine/placement/reach.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/figure/figure.h"
#include "engine/placement/hold_chain.h"

// Levenberg and Marquardt's method on |e(x)|^2 / 2 with bounds, e being p(x) - target and, where an
// orientation is given, the rotation vector from it to R(x). A hinge at a limit that would be
// pushed on is left out of the step, and every step is cut to the limits.

namespace hazumi {

namespace {

constexpr int kSteps = 200;
constexpr double kReached = 1e-9;          // [m]
constexpr double kNearTarget = 1e-6;       // [m]
constexpr double kLargestReachStep = 0.5;  // [rad] of any hinge
constexpr double kBent = 0.1;              // [rad] that a straight limb is bent to begin with
constexpr double kWorthBending = 1e-3;     // [m] that it must come nearer
constexpr double kTurnWeight = 0.2;        // [m/rad]

// 3 numbers, or 6 with the orientation.
using ErrorVec = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 6>;
using ErrorMat = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

std::vector<GroupIndex> JointsUpTo(JointIndex moved, const Figure& figure) {
  constexpr int kRoot = 0;
  return ChainOf(figure.joint(moved).group, kRoot, figure);
}

class ReachSolver {
 public:
  ReachSolver(const Figure& figure, const ReachProblem& problem, const VecX& q)
      : chain_(figure, figure.joint(problem.moved).group, JointsUpTo(problem.moved, figure)),
        X_WR_{problem.X_WR.R.cast<Jet>(), problem.X_WR.p.cast<Jet>()},
        target_(problem.target),
        orientation_(problem.orientation),
        q_(q.data(), q.data() + q.size()),
        pose_(chain_.size()),
        may_turn_(chain_.size()),
        e_(problem.orientation ? 6 : 3),
        J_(e_.size(), chain_.size()) {
    for (int r = 0; r < chain_.size(); ++r) {
      const auto& hinges = problem.hinges;
      may_turn_[r] = std::find(hinges.begin(), hinges.end(), chain_.unknowns()[r]) != hinges.end();
    }
  }

  int size() const { return chain_.size(); }
  JointIndex joint(int row) const { return chain_.unknowns()[row]; }

  // The present angles, those that may turn within their limits.
  VecX Present() const {
    VecX x(size());
    for (int r = 0; r < size(); ++r) x[r] = Limited(r, q_[joint(r).value()].v);
    return x;
  }

  // A straight limb has no first-order way to get shorter: bent towards the middle of the limits (a
  // knee bends backwards), or if it is there, to a side.
  VecX Bent() const {
    VecX x = Present();
    for (int r = 0; r < size(); ++r) {
      const double middle = 0.5 * (chain_.joint(r).lower + chain_.joint(r).upper);
      const double side = r % 2 == 0 ? kBent : -kBent;
      const double by = std::clamp(middle - x[r], -kBent, kBent);
      x[r] = Limited(r, x[r] + (std::abs(by) < 0.5 * kBent ? side : by));
    }
    return x;
  }

  // Leaves the nearest angles in `x`; gives the distance.
  double Minimise(VecX* x) {
    double damping = 1e-4, least = Place(*x);
    for (int i = 0; i < kSteps && least > kReached && damping < 1e8; ++i) {
      SetJacobian(*x);
      const VecX next = Step(*x, damping);
      const double distance = Place(next);
      damping *= distance < least ? 0.3 : 4.0;
      if (distance < least) {
        least = distance;
        *x = next;
      } else {
        Place(*x);
      }
    }
    return least;
  }

 private:
  double Limited(int row, double angle) const {
    if (!may_turn_[row]) return q_[joint(row).value()].v;
    return std::clamp(angle, chain_.joint(row).lower, chain_.joint(row).upper);
  }

  double Place(const VecX& x) {
    chain_.Place<double>(X_WR_, q_, x, &pose_);
    e_.head<3>() = pose_.p - target_;
    if (orientation_) {
      const Eigen::AngleAxisd off(Mat3(pose_.R * orientation_->transpose()));
      e_.tail<3>() = kTurnWeight * off.angle() * off.axis();
    }
    return e_.norm();
  }

  // Of e, with respect to a hinge's angle; of the rotation vector as if it were short.
  ErrorVec Slope(int row) const {
    ErrorVec slope(e_.size());
    slope.head<3>() = pose_.J[row];
    if (orientation_) slope.tail<3>() = kTurnWeight * pose_.axis[row];
    return slope;
  }

  // At pose_, without the hinges that cannot go where they should.
  void SetJacobian(const VecX& x) {
    for (int r = 0; r < size(); ++r) {
      const ErrorVec slope = Slope(r);
      const double uphill = slope.dot(e_);
      const bool stopped = (x[r] <= chain_.joint(r).lower && uphill > 0.0) ||
                           (x[r] >= chain_.joint(r).upper && uphill < 0.0);
      J_.col(r).setZero();
      if (may_turn_[r] && !stopped) J_.col(r) = slope;
    }
  }

  // (J^T J + damping)^-1 J^T = J^T (J J^T + damping)^-1.
  VecX Step(const VecX& x, double damping) const {
    ErrorMat A = J_ * J_.transpose();
    A.diagonal().array() += damping;
    VecX step = -J_.transpose() * A.ldlt().solve(e_);
    const double largest = size() > 0 ? step.cwiseAbs().maxCoeff() : 0.0;
    if (largest > kLargestReachStep) step *= kLargestReachStep / largest;
    for (int r = 0; r < size(); ++r) step[r] = Limited(r, x[r] + step[r]);
    return step;
  }

  HoldChain chain_;
  PoseOf<Jet> X_WR_;
  Vec3 target_;
  std::optional<Mat3> orientation_;
  std::vector<Jet> q_;
  ChainPose<double> pose_;
  std::vector<char> may_turn_;                                     // by row of the chain
  ErrorVec e_;                                                     // at pose_
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 6> J_;  // of e, by row of the chain
};

// From `q`; leaves the nearest angles there.
double Solve(const Figure& figure, const ReachProblem& problem, VecX* q) {
  ReachSolver solver(figure, problem, *q);
  VecX x = solver.Present();
  double distance = solver.Minimise(&x);
  if (distance > kReached) {
    VecX bent = solver.Bent();
    const double distance_bent = solver.Minimise(&bent);
    if (distance_bent < distance - kWorthBending ||
        (distance_bent <= kReached && distance > kNearTarget)) {
      distance = distance_bent;
      x = bent;
    }
  }
  for (int r = 0; r < solver.size(); ++r) (*q)[solver.joint(r).value()] = x[r];
  return distance;
}

}  // namespace

double Reach(const Figure& figure, const ReachProblem& problem, VecX* q) {
  const double distance = Solve(figure, problem, q);
  if (!problem.orientation || distance <= kNearTarget) return distance;
  ReachProblem place = problem;
  place.orientation.reset();
  return Solve(figure, place, q);
}

}  // namespace hazumi
