#include "engine/solve/aim_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/base/assert.h"
#include "engine/collision/distance.h"
#include "engine/spatial/degrees.h"

namespace hazumi::solve {

namespace {

constexpr double kBound = 30.0;             // w_b
constexpr double kLimit = 1.0 / kDegree;    // w_l
constexpr double kAngle = 100.0;            // w_a
constexpr double kRate = 3.0;               // w_r [s]
constexpr double kInside = 0.25 * kDegree;  // how far inside a limit pushes begin
constexpr double kPair = 1000.0;            // w_o [1/m]
constexpr int kOrder = 4;  // of the splines: each interval has so many coefficients

}  // namespace

std::vector<Mat3> TurnsOf(const AimProblem& problem, const VecX& angles) {
  std::vector<Mat3> turns;
  turns.reserve(problem.hinges.size());
  for (size_t j = 0; j < problem.hinges.size(); ++j) {
    const Vec3& axis = problem.chain.joints[j].axes[0].axis;
    turns.push_back(problem.hinges[j].before *
                    Eigen::AngleAxisd(angles[static_cast<int>(j)], axis).toRotationMatrix());
  }
  return turns;
}

AimSolver::AimSolver(const AimProblem& problem, const MatX& angles)
    : problem_(problem),
      unknowns_(problem.chain),
      share_(std::sqrt(1.0 / std::max(problem.chain.num_frames() - 2, 1))),
      torques_(MatX::Zero(num_hinges(), num_frames())),
      changes_(static_cast<size_t>(num_frames())) {
  HAZUMI_DEMAND(num_frames() > 3 && angles.rows() == num_hinges() &&
                angles.cols() == num_frames() && problem.knots.front() == 1 &&
                problem.knots.back() == num_frames() - 1);
  FillBasis();
  FitTo(angles);
}

// B_k by recursion [Cox 1972]; the first and the last knot count four times.
void AimSolver::FillBasis() {
  std::vector<double> knots(kOrder - 1, problem_.knots.front());
  knots.insert(knots.end(), problem_.knots.begin(), problem_.knots.end());
  knots.insert(knots.end(), kOrder - 1, problem_.knots.back());
  const int count = static_cast<int>(knots.size()) - kOrder;
  basis_ = MatX::Zero(num_frames(), count);
  const auto knot = [&](int i) { return knots[static_cast<size_t>(i)]; };
  for (int t = 1; t < num_frames(); ++t) {
    int at = kOrder - 1;
    while (at + 1 < count && t >= knot(at + 1)) ++at;
    VecX values = VecX::Zero(count + kOrder);
    values[at] = 1.0;
    for (int order = 2; order <= kOrder; ++order) {
      for (int k = at - order + 1; k <= at; ++k) {
        const double left = knot(k + order - 1) - knot(k), right = knot(k + order) - knot(k + 1);
        values[k] = (left > 0.0 ? (t - knot(k)) / left * values[k] : 0.0) +
                    (right > 0.0 ? (knot(k + order) - t) / right * values[k + 1] : 0.0);
      }
    }
    basis_.row(t) = values.head(count).transpose();
  }
}

// Least squares; what the start gives stays.
void AimSolver::FitTo(const MatX& angles) {
  const int count = num_coefficients(), frames = num_frames() - 1;
  coefficients_ = MatX::Zero(num_hinges(), count);
  const double d = (problem_.knots[1] - problem_.knots[0]) * problem_.chain.step;
  const MatX known = basis_.bottomRows(frames).leftCols(2);
  const MatX rest = basis_.bottomRows(frames).rightCols(count - 2);
  MatX normal = rest.transpose() * rest;
  const Eigen::LDLT<MatX> factor(normal);
  for (int j = 0; j < num_hinges(); ++j) {
    const AimHinge& hinge = problem_.hinges[static_cast<size_t>(j)];
    if (!hinge.moves) continue;
    coefficients_(j, 0) = angles(j, 1);
    coefficients_(j, 1) = angles(j, 1) + hinge.start_rate * d / 3.0;
    const VecX path =
        angles.row(j).tail(frames).transpose() - known * coefficients_.row(j).head(2).transpose();
    coefficients_.row(j).tail(count - 2) = factor.solve(rest.transpose() * path).transpose();
  }
}

AimedMotion AimSolver::Solve() {
  BandSystem system((num_coefficients() - 2) * num_hinges(),
                    std::min(num_coefficients() - 2, kOrder + 2) * num_hinges());
  const SquaresLimits limits = {30, 1e-3, 0.5};
  AimedMotion found;
  // First without torques, which is nearly linear.
  has_torques_ = false;
  Minimize(limits, this, &system);
  has_torques_ = true;
  found.report = Minimize(limits, this, &system);
  system.Clear();
  Linearize(&system);
  found.angles = AnglesOf(coefficients_);
  found.torques = torques_;
  return found;
}

// A frame stands for the time half-way to its neighbours; the last one with a torque for the rest,
// too.
double AimSolver::ShareAt(int t) const {
  const double frames = t == 1 ? 0.5 : t + 2 == num_frames() ? 1.5 : 1.0;
  return share_ * std::sqrt(frames);
}

bool AimSolver::IsFree(int coefficient, int hinge) const {
  return coefficient >= 2 && problem_.hinges[static_cast<size_t>(hinge)].moves;
}

// The frame before the start follows from the rates there.
MatX AimSolver::AnglesOf(const MatX& coefficients) const {
  MatX angles = coefficients * basis_.transpose();
  for (int j = 0; j < num_hinges(); ++j) {
    const AimHinge& hinge = problem_.hinges[static_cast<size_t>(j)];
    if (hinge.moves) {
      angles(j, 0) = angles(j, 2) - 2.0 * problem_.chain.step * hinge.start_rate;
    } else {
      angles.row(j) = problem_.given.row(j);
    }
  }
  return angles;
}

double AimSolver::CostAfter(const VecX& step) {
  moved_ = coefficients_;
  for (int k = 2; k < num_coefficients(); ++k) {
    for (int j = 0; j < num_hinges(); ++j) {
      if (IsFree(k, j)) moved_(j, k) += step[Number(k, j)];
    }
  }
  return Terms(moved_, nullptr);
}

double AimSolver::Add(int first, int count, const MatX& J, const VecX& r,
                      BandSystem* system) const {
  if (!system) return r.squaredNorm();
  const int n = num_hinges();
  int from = num_coefficients(), to = 2;  // coefficients that it touches
  for (int k = 2; k < num_coefficients(); ++k) {
    if (basis_.col(k).segment(first, count).isZero(0.0)) continue;
    from = std::min(from, k);
    to = k + 1;
  }
  if (from >= to) return r.squaredNorm();
  MatX by = MatX::Zero(r.size(), (to - from) * n);
  for (int k = from; k < to; ++k) {
    for (int j = 0; j < n; ++j) {
      if (!IsFree(k, j)) continue;
      for (int s = 0; s < count; ++s) {
        by.col((k - from) * n + j) += basis_(first + s, k) * J.col(s * n + j);
      }
    }
  }
  system->Add(Number(from, 0), by, r);
  return r.squaredNorm();
}

double AimSolver::AddOf(int hinge, int first, const VecX& change, double r,
                        BandSystem* system) const {
  if (!system) return r * r;
  const int count = static_cast<int>(change.size());
  std::vector<int> unknowns;
  VecX J(num_coefficients());
  for (int k = 2; k < num_coefficients(); ++k) {
    const double by = basis_.col(k).segment(first, count).dot(change);
    if (by == 0.0) continue;
    J[static_cast<int>(unknowns.size())] = by;
    unknowns.push_back(Number(k, hinge));
  }
  system->Add(unknowns, J, r);
  return r * r;
}

double AimSolver::Terms(const MatX& coefficients, BandSystem* system) {
  const MatX angles = AnglesOf(coefficients);
  double cost = 0.0;
  for (int t = 1; has_torques_ && t + 1 < num_frames(); ++t) cost += TorqueTerm(angles, t, system);
  for (int t = 1; t < num_frames(); ++t) {
    for (int j = 0; j < num_hinges(); ++j) {
      if (problem_.hinges[static_cast<size_t>(j)].moves) cost += OwnTerms(angles, t, j, system);
    }
  }
  for (int t = 2; t < num_frames() && !problem_.pairs.empty(); ++t) {
    cost += PairTerms(angles, t, system);
  }
  for (const AimAngle& asked : problem_.angles) {
    const double r = kAngle * (angles(asked.hinge, asked.frame) - asked.angle);
    cost += AddOf(asked.hinge, asked.frame, VecX::Constant(1, kAngle), r, system);
  }
  for (const AimRate& asked : problem_.rates) {
    // A central difference; at the end that of the parabola through the last three frames.
    const bool is_end = asked.frame + 1 == num_frames();
    const int first = asked.frame - (is_end ? 2 : 1);
    const Vec3 difference = is_end ? Vec3(0.5, -2.0, 1.5) : Vec3(-0.5, 0.0, 0.5);
    const Vec3 change = kRate / problem_.chain.step * difference;
    const double r =
        angles.row(asked.hinge).segment(first, 3).dot(change.transpose()) - kRate * asked.rate;
    cost += AddOf(asked.hinge, first, change, r, system);
  }
  return cost;
}

// Friction is an acceleration: with both neighbours moved on by C h^2 q' / 2 the second difference
// is h^2 (q'' + C q'), and the first one stays.
double AimSolver::TorqueTerm(const MatX& angles, int t, BandSystem* system) {
  const Chain& chain = problem_.chain;
  const int n = num_hinges();
  VecX kappa(n);
  for (int j = 0; j < n; ++j) {
    const AimHinge& hinge = problem_.hinges[static_cast<size_t>(j)];
    kappa[j] = hinge.moves ? 0.25 * hinge.friction * chain.step : 0.0;
  }
  const VecX on = kappa.cwiseProduct(angles.col(t + 1) - angles.col(t - 1));
  const ChainPose before = PoseOfChain(chain, t - 1, TurnsOf(problem_, angles.col(t - 1) + on));
  const ChainPose now = PoseOfChain(chain, t, TurnsOf(problem_, angles.col(t)));
  const ChainPose after = PoseOfChain(chain, t + 1, TurnsOf(problem_, angles.col(t + 1) + on));
  ChainMoments moments(chain, t, before, now, after);
  VecX torques = VecX::Zero(n), scale = VecX::Zero(n), r(2 * n);
  for (int j = 0; j < n; ++j) {
    const AimHinge& hinge = problem_.hinges[static_cast<size_t>(j)];
    if (!hinge.moves) continue;
    torques[j] = moments.Torques(j)[0];
    scale[j] = ShareAt(t) / hinge.strength;
  }
  r.head(n) = scale.cwiseProduct(torques);
  VecX beyond = VecX::Zero(n);  // derivative of the part beyond the bound
  for (int j = 0; j < n; ++j) {
    const double most = ShareAt(t) * problem_.most;
    const bool is_bounded = problem_.hinges[static_cast<size_t>(j)].is_bounded;
    const double excess = is_bounded ? std::abs(r[j]) - most : 0.0;
    r[n + j] = excess > 0.0 ? kBound * std::copysign(excess, r[j]) : 0.0;
    if (excess > 0.0) beyond[j] = kBound;
  }
  if (!system) return r.squaredNorm();
  torques_.col(t) = torques;
  MatX a = MatX::Zero(n, n), x = MatX::Zero(n, n), z = MatX::Zero(n, n);
  for (int j = 0; j < n; ++j) {
    if (!problem_.hinges[static_cast<size_t>(j)].moves) continue;
    moments.Differentiate(-1, j, 0, unknowns_, a.col(j));
    moments.Differentiate(0, j, 0, unknowns_, x.col(j));
    moments.Differentiate(1, j, 0, unknowns_, z.col(j));
  }
  Changes& changes = changes_[static_cast<size_t>(t)];
  const auto k = kappa.asDiagonal();
  changes.before = a - (a + z) * k;
  changes.now = x;
  changes.after = z + (a + z) * k;
  MatX J = MatX::Zero(2 * n, 3 * n);
  J.topLeftCorner(n, n) = changes.before;
  J.block(0, n, n, n) = changes.now;
  J.topRightCorner(n, n) = changes.after;
  // Frame 0 follows frame 2.
  if (t == 1) J.topRightCorner(n, n) += changes.before;
  J.topRows(n) = (scale.asDiagonal() * J.topRows(n)).eval();
  if (beyond.isZero(0.0)) {
    return Add(t - 1, 3, J.topRows(n), r.head(n), system);
  }
  J.bottomRows(n) = beyond.asDiagonal() * J.topRows(n);
  // Row 0 of the basis is zero.
  return Add(t - 1, 3, J, r, system);
}

double AimSolver::OwnTerms(const MatX& angles, int t, int j, BandSystem* system) const {
  const AimHinge& hinge = problem_.hinges[static_cast<size_t>(j)];
  const double h = problem_.chain.step;
  double cost = 0.0;
  if (t + 1 < num_frames()) {
    const double w = ShareAt(t) * problem_.acceleration / (h * h);
    const double r = w * (angles(j, t + 1) - 2.0 * angles(j, t) + angles(j, t - 1));
    const Vec3 change = t == 1 ? Vec3(0.0, -2.0 * w, 2.0 * w) : Vec3(w, -2.0 * w, w);
    cost += AddOf(j, t - 1, change, r, system);
  }
  const double w = share_ * kLimit;
  const double angle = angles(j, t);
  const double above = angle - (hinge.upper - kInside), below = angle - (hinge.lower + kInside);
  if (above > 0.0 || below < 0.0) {
    cost += AddOf(j, t, VecX::Constant(1, w), w * (above > 0.0 ? above : below), system);
  }
  return cost;
}

double AimSolver::PairTerms(const MatX& angles, int t, BandSystem* system) const {
  const double clearance = problem_.clearance[t], w = share_ * kPair;
  const ChainPose pose = PoseOfChain(problem_.chain, t, TurnsOf(problem_, angles.col(t)));
  double cost = 0.0;
  for (const AimPair& pair : problem_.pairs) {
    const ChainPose::Body& body = pose.bodies[static_cast<size_t>(pair.hinge)];
    const Capsule capsule = {body.o + body.W * pair.capsule.a, body.o + body.W * pair.capsule.b,
                             pair.capsule.radius};
    const Distance distance = SignedDistance(capsule, pair.obstacle);
    if (distance.value >= clearance) continue;
    MatX J = MatX::Zero(1, num_hinges());
    for (int j = 0; j <= pair.hinge; ++j) {
      const ChainPose::Body& by = pose.bodies[static_cast<size_t>(j)];
      const Vec3 moved = by.axes.col(0).cross(distance.point_on_capsule - by.o);
      J(0, j) = -w * distance.normal.dot(moved);
    }
    cost += Add(t, 1, J, VecX::Constant(1, w * (clearance - distance.value)), system);
  }
  return cost;
}

std::vector<MatX> AimSolver::ChangesWith(const MatX& weights) const {
  const int n = num_hinges(), count = static_cast<int>(weights.cols());
  std::vector<int> moving;
  for (int j = 0; j < n; ++j) {
    if (problem_.hinges[static_cast<size_t>(j)].moves) moving.push_back(j);
  }
  std::vector<MatX> changes(static_cast<size_t>(num_frames()), MatX::Zero(n, n * count));
  for (int t = 1; t + 1 < num_frames(); ++t) {
    const size_t at = static_cast<size_t>(t);
    const Changes& by = changes_[at];
    MatX after = by.after;
    if (t == 1) after += by.before;  // frame 0 follows frame 2
    MatX push = -by.now * changes[at];
    if (t > 1) push -= by.before * changes[at - 1];
    for (const int j : moving) push.block(j, j * count, 1, count) += weights.row(t);
    const MatX H = after(moving, moving), asked = push(moving, Eigen::all);
    const MatX found = H.partialPivLu().solve(asked);
    changes[at + 1](moving, Eigen::all) = found;
  }
  return changes;
}

}  // namespace hazumi::solve
