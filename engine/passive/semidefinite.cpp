#include "engine/passive/semidefinite.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/spatial/smooth_step.h"

namespace hazumi {

namespace {

// What rounding leaves of a pivot that is zero: of its diagonal, and of the largest.
constexpr double kLost = 1e-13, kLostOfAll = 1e-17;

// Numbers of X from which on blocks are worth their while.
constexpr Eigen::Index kManyNumbers = 400;

void SolveLowerOf(const Eigen::Ref<const MatX>& L, double* x) {
  const Eigen::Index n = L.rows();
  for (Eigen::Index k = 0; k < n; ++k) {
    const double* column = L.data() + k * L.outerStride();
    x[k] = column[k] > 0.0 ? x[k] / column[k] : 0.0;
    if (x[k] == 0.0) continue;
    for (Eigen::Index i = k + 1; i < n; ++i) x[i] -= column[i] * x[k];
  }
}

}  // namespace

int FactorSemidefinite(Eigen::Ref<MatX> A) {
  const Eigen::Index n = A.rows();
  int lost = 0;
  double largest = 0.0;
  for (Eigen::Index k = 0; k < n; ++k) largest = std::max(largest, A(k, k));
  for (Eigen::Index k = 0; k < n; ++k) {
    const double diagonal = A(k, k);
    double* column = &A(0, k);
    for (Eigen::Index j = 0; j < k; ++j) {
      const double factor = A(k, j);
      if (factor == 0.0) continue;
      const double* other = &A(0, j);
      for (Eigen::Index i = k; i < n; ++i) column[i] -= factor * other[i];
    }
    if (column[k] > std::max(kLost * diagonal, kLostOfAll * largest)) {
      const double root = std::sqrt(column[k]);
      const double inverse = 1.0 / root;
      column[k] = root;
      for (Eigen::Index i = k + 1; i < n; ++i) column[i] *= inverse;
    } else {
      for (Eigen::Index i = k; i < n; ++i) column[i] = 0.0;
      ++lost;
    }
  }
  return lost;
}

void SolveSemidefinite(const Eigen::Ref<const MatX>& L, Eigen::Ref<VecX> x) {
  SolveLowerOf(L, x.data());
  SolveUpper(L, x);
}

void SolveUpper(const Eigen::Ref<const MatX>& L, Eigen::Ref<VecX> x) {
  const Eigen::Index n = L.rows();
  for (Eigen::Index k = n - 1; k >= 0; --k) {
    const double* column = L.data() + k * L.outerStride();
    if (column[k] <= 0.0) {
      x[k] = 0.0;
      continue;
    }
    double sum = x[k];
    for (Eigen::Index i = k + 1; i < n; ++i) sum -= column[i] * x[i];
    x[k] = sum / column[k];
  }
}

void SolveLower(const Eigen::Ref<const MatX>& L, Eigen::Ref<MatX> X) {
  if (X.size() < kManyNumbers) {
    for (Eigen::Index k = 0; k < X.cols(); ++k) SolveLowerOf(L, &X(0, k));
    return;
  }
  MatX stiff = L;
  for (Eigen::Index k = 0; k < L.cols(); ++k) {
    if (L(k, k) <= 0.0) stiff(k, k) = std::numeric_limits<double>::infinity();
  }
  stiff.triangularView<Eigen::Lower>().solveInPlace(X);
}

VecX LeastNorm(const MatX& A, const VecX& b) {
  if (b.size() == 0) return b;
  // Of an eigenvalue, against 1: said twice, and, surely, not. In between it counts in part, so
  // that forces do not jump where rows come to say the same.
  constexpr double kSaidTwice = 1e-9, kSaidOnce = 1e-8, kSurely = 1e-7;
  // What rounding leaves of a row without any hold is not to be scaled up.
  const double none = 1e-12 * A.diagonal().maxCoeff();
  const VecX unit = A.diagonal().unaryExpr(
      [none](double square) { return square > none ? 1.0 / std::sqrt(square) : 0.0; });
  const MatX scaled = unit.asDiagonal() * A * unit.asDiagonal();
  MatX L = scaled;
  VecX x = unit.cwiseProduct(b);
  if (FactorSemidefinite(L) == 0 && L.diagonal().minCoeff() > std::sqrt(kSurely)) {
    SolveSemidefinite(L, x);
    return unit.cwiseProduct(x);
  }
  const Eigen::SelfAdjointEigenSolver<MatX> eigen(scaled);
  VecX parts = eigen.eigenvectors().transpose() * x;
  for (Eigen::Index k = 0; k < parts.size(); ++k) {
    const double value = eigen.eigenvalues()[k];
    const double share = std::clamp((value - kSaidTwice) / (kSaidOnce - kSaidTwice), 0.0, 1.0);
    parts[k] = share > 0.0 ? SmoothStep(share) * parts[k] / value : 0.0;
  }
  return unit.cwiseProduct(eigen.eigenvectors() * parts);
}

VecX SolveGivingWay(MatX A, const VecX& b, const VecX& softness) {
  constexpr double kGivesWay = 1e-9;
  const double largest = A.diagonal().lpNorm<Eigen::Infinity>();
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    A(i, i) += kGivesWay * softness[i] * std::max(std::abs(A(i, i)), 1e-6 * largest) + 1e-300;
  }
  return A.partialPivLu().solve(b);
}

}  // namespace hazumi
