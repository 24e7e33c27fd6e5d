#pragma once

#include "engine/spatial/types.h"

namespace hazumi {

// Replaces the lower triangle of the symmetric positive semidefinite matrix A by L with A = L L^T.
// A coordinate that moves no mass of its own (its pivot is lost to rounding) gets an empty column.
// Returns how many there are. What is above the diagonal is not kept. Allocates nothing.
int FactorSemidefinite(Eigen::Ref<MatX> A);
// x := a solution of A x = b with b = x on entry, for A as FactorSemidefinite left it: coordinates
// that move no mass get 0.
void SolveSemidefinite(const Eigen::Ref<const MatX>& L, Eigen::Ref<VecX> x);

// Its two halves: X := L^-1 X of many columns at once, x := L^-T x.
void SolveLower(const Eigen::Ref<const MatX>& L, Eigen::Ref<MatX> X);
void SolveUpper(const Eigen::Ref<const MatX>& L, Eigen::Ref<VecX> x);

// x := A^-1 x for any regular A, which is not kept. Numbers that are not finite: it was singular.
void SolveGeneral(Eigen::Ref<MatX> A, Eigen::Ref<VecX> x);

// X^T Y; the same matrix twice gives a symmetric one.
MatX ProductOf(const MatX& X, const MatX& Y);

// The smallest x of those that make A x - b least, for a symmetric positive semidefinite A of a few
// rows, each in units of its own: what two rows say twice is shared between them.
VecX LeastNorm(const MatX& A, const VecX& b);

// x with A x = b where every row gives way by a billionth of what it holds, times its `softness`,
// which shares out what rows say twice; A need not be symmetric, but if it is that is faster.
VecX SolveGivingWay(MatX A, bool is_symmetric, const VecX& b, const VecX& softness);

}  // namespace hazumi
