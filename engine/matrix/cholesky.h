#pragma once

#include "engine/spatial/types.h"

namespace hazumi {

// Replaces the lower triangle of the symmetric matrix A by its Cholesky factor L, A = L L^T.
// Returns -1, or the first row whose pivot is not safely positive (A is then of no further use).
// Allocates nothing.
int FactorCholesky(Eigen::Ref<MatX> A);
// x := A^-1 x, with A as FactorCholesky left it.
void SolveCholesky(const Eigen::Ref<const MatX>& L, Eigen::Ref<VecX> x);

}  // namespace hazumi
