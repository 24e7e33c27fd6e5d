#pragma once

namespace hazumi {

// The innermost loops of dense equations, for one instruction set; every set gives the same bits.
// Matrices are column-major, with `stride` numbers from a column to the next.
struct DenseKernels {
  // As FactorSemidefinite, of n x n numbers; what is above the diagonal is not kept.
  int (*factor)(double* A, long stride, long n);
  // x := A^-1 x, A n x n and regular, by elimination with exchanges of rows, of which `exchanged`
  // holds n. A is not kept.
  void (*solve_general)(double* A, long stride, long n, long* exchanged, double* x);
  // X := L^-1 X for the lower triangle L; what has no pivot becomes 0. X: n x count.
  void (*solve_lower)(const double* L, long stride, long n, double* X, long x_stride, long count);
  // C := X^T Y, of n x columns and n x rows numbers; with Y the same as X the half above is copied.
  void (*product)(const double* X, long x_stride, long columns, const double* Y, long y_stride,
                  long rows, long n, double* C, long c_stride);
  // y -= F abc, of n x 3 and three numbers; `rounded` leaves nothing of what is left to rounding.
  void (*subtract_three)(const double* F, long stride, const double* abc, long n, double* y);
  void (*subtract_three_rounded)(const double* F, long stride, const double* abc, long n,
                                 double* y);
  // y += J abc - F def, of n x 3 and three numbers each.
  void (*add_threes)(const double* J, const double* F, long stride, const double* abc,
                     const double* def, long n, double* y);
};

DenseKernels BaselineDenseKernels();
DenseKernels Avx2DenseKernels();
// Those that the processor can run.
const DenseKernels& BestDenseKernels();

}  // namespace hazumi
