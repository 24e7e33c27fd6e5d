#include "engine/region/exact/limit_solver.h"

#include <algorithm>
#include <cmath>

#include "engine/matrix/semidefinite.h"
#include "engine/spatial/checks.h"

namespace hazumi {

void LimitSolver::Resize(int size) {
  A_.resize(0, 0);
  for (VecX* x : {&x_, &T_, &right_, &given_, &size_, &reached_, &against_}) x->resize(size);
  zero_ = VecX::Zero(size);
  free_.reserve(size);
  held_.assign(size, 0);
}

void LimitSolver::SolveMixed(const MatX& M, const VecX& b, const VecX& given,
                             const std::vector<char>& held, const LimitRows* rows) {
  const int n = static_cast<int>(b.size());
  if (A_.cols() != n) A_.resize(n, n);
  free_.clear();
  for (int i = 0; i < n; ++i) {
    if (!held[i]) free_.push_back(i);
  }
  const int k = static_cast<int>(free_.size());
  constexpr double kEntry = 4e-3;  // cost of an entry of M, in evaluations
  work_ += kEntry * static_cast<double>(n) * n;
  for (int r = 0; r < k; ++r) {
    const int i = free_[r];
    double right = -b[i];
    for (int j = 0; j < n; ++j) {
      if (held[j]) right -= M(i, j) * given[j];
    }
    right_[r] = right;
    for (int c = 0; c <= r; ++c) A_(r, c) = M(i, free_[c]);
  }
  FactorSemidefinite(A_.topLeftCorner(k, k));
  SolveSemidefinite(A_.topLeftCorner(k, k), right_.head(k));
  if (rows) KeepRows(*rows, given, held);
  x_ = given;
  for (int r = 0; r < k; ++r) x_[free_[r]] = right_[r];
  for (int i = 0; i < n; ++i) {
    T_[i] = held[i] ? b[i] + M.row(i).dot(x_) : 0.0;
    size_[i] = held[i] ? std::abs(b[i]) + M.row(i).cwiseAbs().dot(x_.cwiseAbs()) : 0.0;
    if (rows && held[i]) T_[i] -= rows->push().col(i).dot(l_);
  }
  largest_T_ = T_.lpNorm<Eigen::Infinity>();
}

// right_ := what the hinges that are not held do with the rows' forces l_:
//   (J_f M_ff^-1 P_f^T + G) l = -(J_f x_f + J_h x_h + c)
void LimitSolver::KeepRows(const LimitRows& rows, const VecX& given,
                           const std::vector<char>& held) {
  const auto k = static_cast<Eigen::Index>(free_.size());
  MatX J(k, rows.J.rows());
  VecX errors = rows.c;
  for (Eigen::Index r = 0; r < k; ++r) {
    J.row(r) = rows.J.col(free_[r]);
    errors += rows.J.col(free_[r]) * right_[r];
  }
  for (size_t i = 0; i < held.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    if (held[i]) errors += rows.J.col(at) * given[at];
  }
  MatX answer = J;
  if (rows.P.size() > 0) {
    for (Eigen::Index r = 0; r < k; ++r) answer.row(r) = rows.P.col(free_[r]);
  }
  const auto L = A_.topLeftCorner(k, k);
  SolveLower(L, answer);
  if (rows.P.size() > 0) SolveLower(L, J);
  const MatX A = ProductOf(rows.P.size() > 0 ? J : answer, answer) + rows.G;
  l_ = rows.softness.size() > 0 ? SolveGivingWay(A, /*is_symmetric=*/false, -errors, rows.softness)
                                : -LeastNorm(A, errors);
  VecX answered = answer * l_;
  SolveUpper(L, answered);
  right_.head(k) += answered;
}

void LimitSolver::Solve(const MatX& M, const VecX& b, const std::vector<char>& held,
                        const LimitRows* rows) {
  HAZUMI_ASSERT(M.rows() == b.size() && held.size() == static_cast<size_t>(b.size()));
  SolveMixed(M, b, zero_, held, rows);
}

// The first hinge at a limit that is held but would have to be pulled, or is not held and goes out.
int LimitSolver::FirstWrong(const std::vector<int>& side, const VecX& reached, double fastest,
                            const std::vector<char>& fixed, const std::vector<char>& held) const {
  double scale_x = reached.lpNorm<Eigen::Infinity>();
  if (tells_motion_from_rounding_) scale_x = std::max(scale_x, fastest);
  for (int i = 0; i < static_cast<int>(side.size()); ++i) {
    if (side[i] == 0 || fixed[i]) continue;
    if (held[i] ? side[i] * T_[i] > RoundingOf(i) : side[i] * reached[i] > kRounding * scale_x) {
      return i;
    }
  }
  return -1;
}

void LimitSolver::Impact(const MatX& M, const VecX& impulse, const std::vector<int>& side,
                         const std::vector<char>& sticks, VecX* v, const LimitRows* rows) {
  HAZUMI_ASSERT(M.rows() == v->size() && IsSymmetric(M));
  HAZUMI_ASSERT(impulse.size() == v->size() && side.size() == static_cast<size_t>(v->size()));
  HAZUMI_ASSERT(sticks.size() == side.size() && IsFinite(*v));
  const int n = static_cast<int>(v->size());
  against_ = -impulse;
  given_ = -*v;
  const double fastest = v->lpNorm<Eigen::Infinity>();
  for (int i = 0; i < n; ++i) held_[i] = side[i] != 0 && (sticks[i] || side[i] * (*v)[i] >= 0.0);
  for (int pivots = 0; pivots < 64 * (n + 1); ++pivots) {
    SolveMixed(M, against_, given_, held_, rows);
    // A hinge that is not held takes what the others give it.
    reached_ = *v + x_;
    const int wrong = FirstWrong(side, reached_, fastest, sticks, held_);
    if (wrong < 0) break;
    held_[wrong] = !held_[wrong];
  }
  for (int i = 0; i < n; ++i) (*v)[i] = held_[i] ? 0.0 : (*v)[i] + x_[i];
}

void LimitSolver::Rest(const MatX& M, const VecX& b, const std::vector<int>& side,
                       const std::vector<char>& fixed, std::vector<char>* held,
                       const LimitRows* rows) {
  HAZUMI_ASSERT(M.rows() == b.size() && IsSymmetric(M));
  HAZUMI_ASSERT(side.size() == static_cast<size_t>(b.size()) && fixed.size() == side.size());
  HAZUMI_ASSERT(held->size() == side.size() && IsFinite(b));
  const int n = static_cast<int>(b.size());
  const double fastest = b.cwiseQuotient(M.diagonal()).lpNorm<Eigen::Infinity>();
  for (int i = 0; i < n; ++i) (*held)[i] = side[i] != 0;
  for (int pivots = 0; pivots < 64 * (n + 1); ++pivots) {
    SolveMixed(M, b, zero_, *held, rows);
    const int wrong = FirstWrong(side, x_, fastest, fixed, *held);
    if (wrong < 0) break;
    (*held)[wrong] = !(*held)[wrong];
  }
}

}  // namespace hazumi
