#include "engine/dynamics/figure_dynamics.h"
#include "engine/passive/dense_kernels.h"

// The loops for any processor.

namespace hazumi {

namespace {
#include "engine/passive/dense_loops.h"
}  // namespace

DenseKernels BaselineDenseKernels() {
  return {Factor, SolveGeneral, SolveLowerColumns, Product, SubtractThree, SubtractThreeRounded};
}

const DenseKernels& BestDenseKernels() {
  static const DenseKernels best =
      BestInstructions() == Instructions::kAvx2 ? Avx2DenseKernels() : BaselineDenseKernels();
  return best;
}

}  // namespace hazumi
