#pragma once

#include <vector>

#include "engine/spatial/types.h"

namespace hazumi {

// Replaces the lower triangle of the symmetric matrix A by its Cholesky factor L, A = L L^T.
// Returns -1, or the first row whose pivot is not safely positive (A is then of no further use).
// Allocates nothing.
int FactorCholesky(Eigen::Ref<MatX> A);
// x := A^-1 x, with A as FactorCholesky left it.
void SolveCholesky(const Eigen::Ref<const MatX>& L, Eigen::Ref<VecX> x);

// The mixed problem [Arai 2.4 (11)]: H qdd = T - B, where for each coordinate either the
// acceleration is given (given[i] true: qdd[i] is read) or the torque is (T[i] is read). Fills in
// the other half of qdd and T. Scratch: A (n x n) and x (n), contents lost. Returns as
// FactorCholesky, -1 for success, with the row counted in the coordinates of H.
int SolveMixed(const Eigen::Ref<const MatX>& H, const Eigen::Ref<const VecX>& B,
               const std::vector<char>& given, Eigen::Ref<MatX> A, Eigen::Ref<VecX> x,
               Eigen::Ref<VecX> qdd, Eigen::Ref<VecX> T);

}  // namespace hazumi
