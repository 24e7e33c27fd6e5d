#include "engine/matrix/eigen_system.h"

#include <Eigen/Eigenvalues>

#include "engine/spatial/checks.h"

namespace hazumi {

EigenSystem EigenSystemOf(const MatX& A) {
  HAZUMI_ASSERT(A.rows() == A.cols());
  const Eigen::SelfAdjointEigenSolver<MatX> solver(A);
  return {solver.eigenvalues(), solver.eigenvectors()};
}

}  // namespace hazumi
