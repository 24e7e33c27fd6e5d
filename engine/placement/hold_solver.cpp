#include "engine/placement/hold_solver.h"

#include <Eigen/LU>
#include <algorithm>

namespace hazumi {

namespace {

template <typename T>
using Vector = Eigen::Matrix<T, Eigen::Dynamic, 1>;

// What the chain looks like at some angles: of every solved hinge the axis and the velocity it
// gives the held joint's origin, world axes.
template <typename T>
struct ChainPose {
  std::vector<Vec3Of<T>> axis, J;
  Vec3Of<T> p;  // held joint's origin
  Mat3Of<T> R;  // body it sits on
};

template <typename T>
T SinOf(const T& x) {
  using std::sin;
  return sin(x);
}
template <typename T>
T CosOf(const T& x) {
  using std::cos;
  return cos(x);
}

// Angle of chain joint i: an unknown if it is solved, else as given.
template <typename T>
ChainPose<T> PoseChain(const Figure& figure, const std::vector<JointIndex>& chain,
                       const std::vector<int>& row_of_chain, JointIndex held,
                       const PoseOf<T>& X_WR, const std::vector<T>& given, const Vector<T>& x,
                       int num_solved) {
  ChainPose<T> pose;
  pose.axis.resize(num_solved);
  pose.J.resize(num_solved);
  std::vector<Vec3Of<T>> origin(num_solved);
  PoseOf<T> X = X_WR;
  for (size_t i = 0; i < chain.size(); ++i) {
    const Joint& joint = figure.joint(chain[i]);
    const int row = row_of_chain[i];
    const T angle = row >= 0 ? x[row] : given[chain[i].value()];
    X.p += X.R * joint.X_PJ.p.cast<T>();
    const Mat3Of<T> turn = AxisRotation<T>(joint.axis, SinOf(angle), CosOf(angle));
    X.R = (X.R * (joint.X_PJ.R.cast<T>() * turn).eval()).eval();
    if (row < 0) continue;
    pose.axis[row] = X.R * joint.axis.cast<T>();
    origin[row] = X.p;
  }
  pose.R = X.R;
  pose.p = X.p + X.R * figure.joint(held).X_PJ.p.cast<T>();
  for (int r = 0; r < num_solved; ++r) pose.J[r] = pose.axis[r].cross(pose.p - origin[r]);
  return pose;
}

// c(q): position error, and the rotation vector's sine of the orientation error.
template <typename T>
Vector<T> Constraint(const ChainPose<T>& pose, const HoldTarget& target, int size) {
  Vector<T> c(size);
  c.template head<3>() = pose.p - target.position.cast<T>();
  if (size == 6) {
    const Mat3Of<T> E = pose.R * target.orientation.transpose().cast<T>();
    const T half(0.5);
    c.template tail<3>() << half * (E(2, 1) - E(1, 2)), half * (E(0, 2) - E(2, 0)),
        half * (E(1, 0) - E(0, 1));
  }
  return c;
}

// F = (q - q_keyed + J^T l, c).
template <typename T>
Vector<T> Stationarity(const ChainPose<T>& pose, const HoldTarget& target,
                       const Vector<T>& keyed, const Vector<T>& x, int n, int m) {
  Vector<T> F(n + m);
  const Vec3Of<T> l = x.template segment<3>(n);
  for (int r = 0; r < n; ++r) F[r] = x[r] - keyed[r] + pose.J[r].dot(l);
  if (m == 6) {
    const Vec3Of<T> l_turn = x.template segment<3>(n + 3);
    for (int r = 0; r < n; ++r) F[r] += pose.axis[r].dot(l_turn);
  }
  F.tail(m) = Constraint(pose, target, m);
  return F;
}

// dF/d(q, l), exact where c = 0. Moving a hinge s nearer the root turns everything beyond it:
// dJ_r/dq_s = axis_s x J_r, d axis_r/dq_s = axis_s x axis_r; a farther one moves only the end:
// dJ_r/dq_s = axis_r x J_s.
MatX Derivative(const ChainPose<double>& pose, const Vector<double>& x, int n, int m) {
  MatX K = MatX::Zero(n + m, n + m);
  const Vec3 l = x.segment<3>(n);
  const Vec3 l_turn = m == 6 ? Vec3(x.segment<3>(n + 3)) : Vec3::Zero();
  for (int r = 0; r < n; ++r) {
    for (int s = 0; s < n; ++s) {
      K(r, s) = pose.axis[std::min(r, s)].cross(pose.J[std::max(r, s)]).dot(l);
      if (s < r) K(r, s) += pose.axis[s].cross(pose.axis[r]).dot(l_turn);
    }
    K(r, r) += 1.0;
    K.block<3, 1>(n, r) = pose.J[r];
    if (m == 6) K.block<3, 1>(n + 3, r) = pose.axis[r];
  }
  K.topRightCorner(n, m) = K.bottomLeftCorner(m, n).transpose();
  return K;
}

constexpr int kMaxIterations = 60;
constexpr double kLargestStep = 0.4;   // [rad] an iteration
constexpr double kConverged = 1e-12;   // [m, rad]

}  // namespace

struct HoldSolver::Newton {
  std::vector<double> given;    // all joints' keyed angles
  Vector<double> keyed;         // the solved ones
  Vector<double> x;             // angles, multipliers
  MatX K;
};

HoldSolver::HoldSolver(const Figure& figure, GroupIndex held, bool hold_orientation)
    : figure_(&figure), held_(figure.group(held).first), hold_orientation_(hold_orientation) {
  for (JointIndex j = figure.joint(held_).parent; j.is_valid(); j = figure.joint(j).parent) {
    chain_.push_back(j);
  }
  std::reverse(chain_.begin(), chain_.end());
  for (const JointIndex j : chain_) {
    const bool fixed = figure.joint(j).is_fixed();
    row_of_chain_.push_back(fixed ? -1 : num_solved());
    if (!fixed) solved_.push_back(j);
  }
}

bool HoldSolver::Converge(const PoseOf<double>& X_WR, const HoldTarget& target,
                          Newton* newton) const {
  const int n = num_solved(), m = num_constraints();
  for (int i = 0; i < kMaxIterations; ++i) {
    const auto pose = PoseChain<double>(*figure_, chain_, row_of_chain_, held_, X_WR, newton->given,
                                        newton->x, n);
    const Vector<double> F = Stationarity(pose, target, newton->keyed, newton->x, n, m);
    newton->K = Derivative(pose, newton->x, n, m);
    if (F.cwiseAbs().maxCoeff() < kConverged) return true;
    Vector<double> step = newton->K.fullPivLu().solve(F);
    const double largest = step.head(n).cwiseAbs().maxCoeff();
    if (largest > kLargestStep) step *= kLargestStep / largest;
    newton->x -= step;
    if (!newton->x.allFinite()) return false;
  }
  return false;
}

// Levenberg-Marquardt on |c|^2 alone; leaves the nearest angles in newton->x.
double HoldSolver::LeastDistance(const PoseOf<double>& X_WR, const HoldTarget& target,
                                 Newton* newton) const {
  const int n = num_solved(), m = num_constraints();
  double damping = 1e-3, best = std::numeric_limits<double>::infinity();
  Vector<double> x = newton->x, tried = x;
  for (int i = 0; i < 4 * kMaxIterations; ++i) {
    const auto pose =
        PoseChain<double>(*figure_, chain_, row_of_chain_, held_, X_WR, newton->given, tried, n);
    const Vector<double> c = Constraint(pose, target, m);
    damping *= c.norm() < best ? 0.3 : 4.0;
    if (c.norm() < best) {
      best = c.norm();
      x = tried;
      newton->K = Derivative(pose, x, n, m);
    }
    if (best < kConverged || damping > 1e12) break;
    const MatX J = newton->K.bottomLeftCorner(m, n);
    const auto now = PoseChain<double>(*figure_, chain_, row_of_chain_, held_, X_WR, newton->given,
                                       x, n);
    const MatX A = J.transpose() * J + damping * MatX::Identity(n, n);
    tried.head(n) = x.head(n) - A.fullPivLu().solve(J.transpose() * Constraint(now, target, m));
  }
  newton->x = x;
  const auto pose =
      PoseChain<double>(*figure_, chain_, row_of_chain_, held_, X_WR, newton->given, x, n);
  return (pose.p - target.position).norm();
}

HoldSolution HoldSolver::Solve(const PoseOf<Jet>& X_WR, const HoldTarget& target,
                               std::vector<Jet>* q) const {
  const int n = num_solved(), m = num_constraints();
  const auto value = [](const Jet& jet) { return jet.v; };
  const PoseOf<double> X{X_WR.R.unaryExpr(value), X_WR.p.unaryExpr(value)};
  Newton newton;
  for (const Jet& jet : *q) newton.given.push_back(jet.v);
  Vector<Jet> keyed(n);
  for (int r = 0; r < n; ++r) keyed[r] = (*q)[solved_[r].value()];
  newton.keyed = keyed.unaryExpr(value);
  newton.x = Vector<double>::Zero(n + m);
  newton.x.head(n) = newton.keyed;
  if (!Converge(X, target, &newton)) {
    newton.x.head(n) = newton.keyed;
    newton.x.tail(m).setZero();
    const double distance = LeastDistance(X, target, &newton);
    newton.x.tail(m).setZero();
    if (!Converge(X, target, &newton)) return {false, distance};
  }
  // Newton's method on the Taylor series: each pass makes one more derivative exact.
  Vector<Jet> x = newton.x.cast<Jet>();
  const auto lu = newton.K.fullPivLu();
  for (int order = 1; order <= 2; ++order) {
    const auto pose = PoseChain<Jet>(*figure_, chain_, row_of_chain_, held_, X_WR, *q, x, n);
    const Vector<Jet> F = Stationarity(pose, target, keyed, x, n, m);
    const Vector<double> d = lu.solve(F.unaryExpr([](const Jet& f) { return f.d; }).eval());
    const Vector<double> dd = lu.solve(F.unaryExpr([](const Jet& f) { return f.dd; }).eval());
    for (int r = 0; r < n + m; ++r) x[r] -= Jet(0.0, d[r], dd[r]);
  }
  for (int r = 0; r < n; ++r) (*q)[solved_[r].value()] = x[r];
  return {true, 0.0};
}

}  // namespace hazumi
