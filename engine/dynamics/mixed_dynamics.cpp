#include "engine/dynamics/mixed_dynamics.h"

#include "engine/matrix/cholesky.h"

namespace hazumi {

int SolveMixed(const Eigen::Ref<const MatX>& H, const Eigen::Ref<const VecX>& B,
               const std::vector<char>& given, Eigen::Ref<MatX> A, Eigen::Ref<VecX> x,
               Eigen::Ref<VecX> qdd, Eigen::Ref<VecX> T) {
  const int n = static_cast<int>(H.rows());
  int free = 0;
  for (int i = 0; i < n; ++i) {
    if (given[i]) continue;
    x[free] = T[i] - B[i];
    for (int j = 0, column = 0; j < n; ++j) {
      if (given[j]) {
        x[free] -= H(i, j) * qdd[j];
      } else {
        A(free, column++) = H(i, j);
      }
    }
    ++free;
  }
  const int pivot = FactorCholesky(A.topLeftCorner(free, free));
  if (pivot < 0) SolveCholesky(A.topLeftCorner(free, free), x.head(free));
  for (int i = 0, k = 0; i < n; ++i) {
    if (given[i]) continue;
    if (k == pivot) return i;
    qdd[i] = x[k++];
  }
  for (int i = 0; i < n; ++i) {
    if (given[i]) T[i] = B[i] + H.row(i).dot(qdd);
  }
  return -1;
}

}  // namespace hazumi
