#include "engine/matrix/dense_kernels.h"
#include "engine/spatial/lanes/cpu.h"

// The loops for any processor.

namespace hazumi {

namespace {
#include "engine/matrix/dense_loops.h"
}  // namespace

DenseKernels BaselineDenseKernels() {
  return {Factor,        SolveGeneral,         SolveLowerColumns, Product,
          SubtractThree, SubtractThreeRounded, AddThrees};
}

const DenseKernels& BestDenseKernels() {
  static const DenseKernels best = CpuHasAvx2() ? Avx2DenseKernels() : BaselineDenseKernels();
  return best;
}

}  // namespace hazumi
