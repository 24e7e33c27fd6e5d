#include "engine/matrix/semidefinite.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/matrix/dense_kernels.h"
#include "engine/matrix/eigen_system.h"
#include "engine/spatial/checks.h"
#include "engine/spatial/smooth_step.h"

namespace hazumi {

int FactorSemidefinite(Eigen::Ref<MatX> A) {
  HAZUMI_ASSERT(A.rows() == A.cols());
  return BestDenseKernels().factor(A.data(), A.outerStride(), A.rows());
}

void SolveSemidefinite(const Eigen::Ref<const MatX>& L, Eigen::Ref<VecX> x) {
  HAZUMI_ASSERT(L.rows() == L.cols() && x.size() == L.rows());
  BestDenseKernels().solve_lower(L.data(), L.outerStride(), L.rows(), x.data(), x.size(), 1);
  SolveUpper(L, x);
}

void SolveUpper(const Eigen::Ref<const MatX>& L, Eigen::Ref<VecX> x) {
  HAZUMI_ASSERT(L.rows() == L.cols() && x.size() == L.rows());
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
  HAZUMI_ASSERT(L.rows() == L.cols() && X.rows() == L.rows());
  BestDenseKernels().solve_lower(L.data(), L.outerStride(), L.rows(), X.data(), X.outerStride(),
                                 X.cols());
}

void SolveGeneral(Eigen::Ref<MatX> A, Eigen::Ref<VecX> x) {
  HAZUMI_ASSERT(A.rows() == A.cols() && x.size() == A.rows());
  std::vector<long> exchanged(static_cast<size_t>(A.rows()));
  BestDenseKernels().solve_general(A.data(), A.outerStride(), A.rows(), exchanged.data(), x.data());
}

MatX ProductOf(const MatX& X, const MatX& Y) {
  HAZUMI_ASSERT(X.rows() == Y.rows());
  MatX C(X.cols(), Y.cols());
  BestDenseKernels().product(X.data(), X.outerStride(), X.cols(), Y.data(), Y.outerStride(),
                             Y.cols(), X.rows(), C.data(), C.outerStride());
  return C;
}

VecX LeastNorm(const MatX& A, const VecX& b) {
  HAZUMI_ASSERT(A.rows() == b.size() && A.cols() == b.size());
  HAZUMI_ASSERT(IsSymmetric(A));
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
  const EigenSystem eigen = EigenSystemOf(scaled);
  VecX parts = eigen.vectors.transpose() * x;
  for (Eigen::Index k = 0; k < parts.size(); ++k) {
    const double value = eigen.values[k];
    const double share = std::clamp((value - kSaidTwice) / (kSaidOnce - kSaidTwice), 0.0, 1.0);
    parts[k] = share > 0.0 ? SmoothStep(share) * parts[k] / value : 0.0;
  }
  return unit.cwiseProduct(eigen.vectors * parts);
}

VecX SolveGivingWay(MatX A, bool is_symmetric, const VecX& b, const VecX& softness) {
  HAZUMI_ASSERT(A.rows() == b.size() && A.cols() == b.size() && softness.size() == b.size());
  HAZUMI_ASSERT(!is_symmetric || IsSymmetric(A));
  HAZUMI_ASSERT(IsNonnegative(softness));
  constexpr double kGivesWay = 1e-9;
  const double largest = A.diagonal().lpNorm<Eigen::Infinity>();
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    A(i, i) += kGivesWay * softness[i] * std::max(std::abs(A(i, i)), 1e-6 * largest) + 1e-300;
  }
  VecX x = b;
  if (is_symmetric) {
    FactorSemidefinite(A);
    SolveSemidefinite(A, x);
  } else {
    SolveGeneral(A, x);
  }
  return x;
}

}  // namespace hazumi
