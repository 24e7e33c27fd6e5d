#include "engine/placement/hold_solver.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

namespace hazumi {

namespace {

constexpr int kNewtonSteps = 30;
constexpr int kDescentSteps = 60;  // without the chain's curvature
constexpr int kDampedSteps = 240;
constexpr int kStarts = 4;
constexpr double kLargestHoldStep = 0.4;  // [rad] an iteration
constexpr double kConverged = 1e-12;      // [m, rad]
constexpr double kBeyond = 1e-9;          // [rad]

// The position error and, for six constraints, sine times axis of the orientation error.
template <typename T>
void SetConstraint(const ChainPose<T>& pose, const HoldTarget& target, Eigen::Ref<VecXOf<T>> c) {
  c.template head<3>() = pose.p - target.position.cast<T>();
  if (c.size() == 3) return;
  const Mat3Of<T> E = pose.R * target.orientation.transpose().cast<T>();
  const T half(0.5);
  c.template tail<3>() << half * (E(2, 1) - E(1, 2)), half * (E(0, 2) - E(2, 0)),
      half * (E(1, 0) - E(0, 1));
}

// F = (q - q_keyed + J^T l, c), n angles q and m multipliers l in x.
template <typename T>
void SetStationarity(const ChainPose<T>& pose, const HoldTarget& target, const VecXOf<T>& keyed,
                     const VecXOf<T>& x, VecXOf<T>* F) {
  const Eigen::Index n = keyed.size(), m = x.size() - n;
  const Vec3Of<T> l = x.template segment<3>(n);
  for (int r = 0; r < n; ++r) (*F)[r] = x[r] - keyed[r] + pose.J[r].dot(l);
  if (m == 6) {
    const Vec3Of<T> l_turn = x.template tail<3>();
    for (int r = 0; r < n; ++r) (*F)[r] += pose.axis[r].dot(l_turn);
  }
  SetConstraint<T>(pose, target, F->tail(m));
}

// The sine is zero after half a turn too.
bool IsTurnedOver(const ChainPose<double>& pose, const HoldTarget& target) {
  return pose.R.cwiseProduct(target.orientation).sum() < 1.0;  // 1 + 2 cos(angle)
}

}  // namespace

HoldSolver::HoldSolver(const Figure& figure, const IkHold& hold)
    : chain_(figure, hold.joint, SolvedJoints(hold, figure)),
      n_(chain_.size()),
      m_(hold.hold_orientation ? 6 : 3),
      pose_(n_),
      pose_jet_(n_),
      keyed_(n_),
      x_(n_ + m_),
      F_(n_ + m_),
      step_(n_ + m_),
      keyed_jet_(n_),
      x_jet_(n_ + m_),
      F_jet_(n_ + m_),
      K_(n_ + m_, n_ + m_),
      lu_(n_ + m_) {}

HoldSolution HoldSolver::Solve(const PoseOf<Jet>& X_WR, const HoldTarget& target,
                               std::vector<Jet>* q, double tolerance) {
  HoldSolution solution = SolveExactly({X_WR, target, *q});
  if (!solution.reached && solution.distance <= tolerance) {
    solution.reached = SolveBeside(X_WR, target, *q);
  }
  for (int r = 0; r < n_ && solution.reached; ++r) (*q)[joints()[r].value()] = x_jet_[r];
  return solution;
}

// Holds the point nearest to the target, or a little farther inside: a limb that is quite straight
// has no rates. Where it is out of reach by next to nothing only the chain's start tells which way
// inside is.
bool HoldSolver::SolveBeside(const PoseOf<Jet>& X_WR, const HoldTarget& target,
                             const std::vector<Jet>& q) {
  const Vec3 nearest = nearest_;
  const Vec3 away = nearest - target.position, to_start = chain_start_ - nearest;
  for (const double inside : {1e-6, 1e-5}) {  // [m]
    for (const Vec3& inwards : {to_start, away}) {
      const HoldTarget beside{nearest + inside * inwards.normalized(), target.orientation};
      if (SolveExactly({X_WR, beside, q}).reached) return true;
    }
  }
  return false;
}

// The solved angles are left in x_jet_.
HoldSolution HoldSolver::SolveExactly(const Problem& problem) {
  for (int r = 0; r < n_; ++r) {
    keyed_jet_[r] = problem.q[joints()[r].value()];
    keyed_[r] = keyed_jet_[r].v;
  }
  StartFrom(0);
  if (!Converge(problem, kNewtonSteps, Hessian::kFull)) {
    double distance = 0.0;
    if (!ConvergeFromAfar(problem, &distance)) return {false, distance};
  }
  if (Excess() > kBeyond) PreferTheLimits(problem);
  FindRates(problem);
  return {true, 0.0};
}

std::vector<Jet> HoldSolver::ChainOf(const std::vector<Jet>& q) const {
  std::vector<Jet> chain;
  chain_.ForEachJoint([&](JointIndex j) { chain.push_back(q[j.value()]); });
  return chain;
}

// Newton's method on F = 0 from x_. Where the chain's part of the Hessian is left out it takes more
// steps, but from far away too it goes towards the nearest solution.
bool HoldSolver::Converge(const Problem& problem, int iterations, Hessian hessian) {
  for (int i = 0; i < iterations; ++i) {
    chain_.Place<double>(problem.X_WR, problem.q, x_, &pose_);
    SetStationarity<double>(pose_, problem.target, keyed_, x_, &F_);
    SetDerivative(hessian);
    Factor();
    if (F_.cwiseAbs().maxCoeff() < kConverged) {
      return m_ == 3 || !IsTurnedOver(pose_, problem.target);
    }
    VecX& step = SolveLinear(F_);
    const double largest = step.head(n_).cwiseAbs().maxCoeff();
    if (largest > kLargestHoldStep) step *= kLargestHoldStep / largest;
    x_ -= step;
    if (!x_.allFinite()) return false;
  }
  return false;
}

// How far any angle is beyond its limits, those that keys put there left out [rad].
double HoldSolver::Excess() const {
  double excess = 0.0;
  for (int r = 0; r < n_; ++r) {
    const double lower = std::min(chain_.joint(r).lower, keyed_[r]);
    const double upper = std::max(chain_.joint(r).upper, keyed_[r]);
    excess = std::max({excess, lower - x_[r], x_[r] - upper});
  }
  return excess;
}

// Looks for a solution about as near to the keyed pose as that in x_ that is less far beyond the
// limits; if there is none, leaves x_ as it is. From a straight limb the other one is about its
// mirror image.
void HoldSolver::PreferTheLimits(const Problem& problem) {
  constexpr double kAsNear = 1.5;  // of squares
  const VecX first = x_;
  const double near = (first.head(n_) - keyed_).squaredNorm(), excess = Excess();
  x_.setZero();
  x_.head(n_) = 2.0 * keyed_ - first.head(n_);
  LeastDistance(problem);
  const bool is_better = Converge(problem, kNewtonSteps, Hessian::kFull) && Excess() < excess &&
                         (x_.head(n_) - keyed_).squaredNorm() <= kAsNear * near;
  if (is_better) return;
  x_ = first;
  Converge(problem, kNewtonSteps, Hessian::kFull);
}

// First onto the target from several starts, then along it to the nearest solution.
bool HoldSolver::ConvergeFromAfar(const Problem& problem, double* distance) {
  *distance = std::numeric_limits<double>::infinity();
  for (int start = 0; start < kStarts; ++start) {
    StartFrom(start);
    const double nearer = LeastDistance(problem);
    if (nearer < *distance) {
      *distance = nearer;
      chain_.Place<double>(problem.X_WR, problem.q, x_, &pose_);
      nearest_ = pose_.p;
      chain_start_ = pose_.origin[0];
    }
    if (Converge(problem, kNewtonSteps, Hessian::kFull)) return true;
    StartFrom(start);
    LeastDistance(problem);
    Converge(problem, kDescentSteps, Hessian::kWithoutChain);
    if (x_.allFinite() && Converge(problem, kNewtonSteps, Hessian::kFull)) return true;
  }
  return false;
}

// The keyed pose; then poses beside it, because a straight limb has no first-order way to get
// shorter: towards the middle of the limits (a knee bends backwards), and to either side.
void HoldSolver::StartFrom(int start) {
  constexpr double kBeside = 0.1;  // [rad]
  x_.setZero();
  for (int r = 0; r < n_; ++r) {
    const double middle = 0.5 * (chain_.joint(r).lower + chain_.joint(r).upper);
    const double side = r % 2 == 0 ? kBeside : -kBeside;
    const double beside[kStarts] = {0.0, std::clamp(middle - keyed_[r], -kBeside, kBeside), side,
                                    -side};
    x_[r] = keyed_[r] + beside[start];
  }
}

// Levenberg and Marquardt's method on |c|^2 from x_; leaves the nearest angles in x_ and the
// multipliers at zero. The orientation counts so much that it is given up last.
double HoldSolver::LeastDistance(const Problem& problem) {
  constexpr double kMetresPerRadian = 30.0;
  VecX weight = VecX::Constant(m_, kMetresPerRadian), c(m_), best_c(m_);
  weight.head<3>().setOnes();
  MatX J(m_, n_);
  VecX best = x_;
  double damping = 1e-3, least = std::numeric_limits<double>::infinity(), distance = least;
  for (int i = 0; i < kDampedSteps && least > kConverged && damping < 1e12; ++i) {
    chain_.Place<double>(problem.X_WR, problem.q, x_, &pose_);
    SetConstraint<double>(pose_, problem.target, c);
    c = c.cwiseProduct(weight).eval();
    const bool better = c.norm() < least;
    damping *= better ? 0.3 : 4.0;
    if (better) {
      least = c.norm();
      distance = c.head<3>().norm();
      best = x_;
      best_c = c;
      SetDerivative(Hessian::kWithoutChain);
      J = weight.asDiagonal() * K_.bottomLeftCorner(m_, n_);
    }
    const MatX A = J.transpose() * J + damping * MatX::Identity(n_, n_);
    x_.head(n_) = best.head(n_) - A.ldlt().solve(J.transpose() * best_c);
  }
  x_ = best;
  return distance;
}

// K = dF/dx at pose_ and x_, exact where c = 0. A hinge s nearer the root turns everything beyond
// it: dJ_r/dq_s = axis_s x J_r, d axis_r/dq_s = axis_s x axis_r; a farther one moves only the end:
// dJ_r/dq_s = axis_r x J_s.
void HoldSolver::SetDerivative(Hessian hessian) {
  K_.setZero();
  const Vec3 l = x_.segment<3>(n_);
  const Vec3 l_turn = m_ == 6 ? Vec3(x_.tail<3>()) : Vec3::Zero();
  for (int r = 0; r < n_; ++r) {
    for (int s = 0; s < n_ && hessian == Hessian::kFull; ++s) {
      K_(r, s) = pose_.axis[std::min(r, s)].cross(pose_.J[std::max(r, s)]).dot(l);
      if (s < r) K_(r, s) += pose_.axis[s].cross(pose_.axis[r]).dot(l_turn);
    }
    K_(r, r) += 1.0;
    K_.block<3, 1>(n_, r) = pose_.J[r];
    if (m_ == 6) K_.block<3, 1>(n_ + 3, r) = pose_.axis[r];
  }
  K_.topRightCorner(n_, m_) = K_.bottomLeftCorner(m_, n_).transpose();
}

// A straight limb, or one of too few hinges, makes K singular: then with full pivoting.
void HoldSolver::Factor() {
  constexpr double kLeastPivot = 1e-11;
  lu_.Factor(K_);
  singular_ = !(lu_.least_pivot() > kLeastPivot);
  if (singular_) lu_singular_.compute(K_);
}

// K^-1 right_side, in step_.
VecX& HoldSolver::SolveLinear(const VecX& right_side) {
  if (singular_) {
    step_ = lu_singular_.solve(right_side);
  } else {
    lu_.Solve(right_side, &step_);
  }
  return step_;
}

// Newton's method on the Taylor series in time: F's rate is linear in the angles' rates, and once
// these are right its acceleration is in their accelerations.
void HoldSolver::FindRates(const Problem& problem) {
  x_jet_ = x_.cast<Jet>();
  for (double Jet::*order : {&Jet::d, &Jet::dd}) {
    chain_.Place<Jet>(problem.X_WR, problem.q, x_jet_, &pose_jet_);
    SetStationarity<Jet>(pose_jet_, problem.target, keyed_jet_, x_jet_, &F_jet_);
    for (int r = 0; r < n_ + m_; ++r) F_[r] = F_jet_[r].*order;
    SolveLinear(F_);
    for (int r = 0; r < n_ + m_; ++r) x_jet_[r].*order -= step_[r];
  }
}

}  // namespace hazumi
