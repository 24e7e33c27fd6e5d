#include "engine/matrix/cholesky.h"

#include <cmath>

namespace hazumi {

int FactorCholesky(Eigen::Ref<MatX> A) {
  const int n = static_cast<int>(A.rows());
  for (int k = 0; k < n; ++k) {
    const double diagonal = A(k, k);
    auto column = A.col(k).tail(n - k);
    for (int j = 0; j < k; ++j) column -= A(k, j) * A.col(j).tail(n - k);
    // A pivot lost to rounding means a joint that moves no mass of its own.
    if (!(A(k, k) > 1e-14 * diagonal)) return k;
    A(k, k) = std::sqrt(A(k, k));
    column.tail(n - k - 1) /= A(k, k);
  }
  return -1;
}

void SolveCholesky(const Eigen::Ref<const MatX>& L, Eigen::Ref<VecX> x) {
  L.triangularView<Eigen::Lower>().solveInPlace(x);
  L.triangularView<Eigen::Lower>().transpose().solveInPlace(x);
}

}  // namespace hazumi
