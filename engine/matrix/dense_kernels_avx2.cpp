#include "engine/matrix/dense_kernels.h"

// For processors with AVX2.

#include "engine/spatial/lanes/avx2_begin.h"

namespace hazumi {

namespace {
#include "engine/matrix/dense_loops.h"
}  // namespace

DenseKernels Avx2DenseKernels() {
  return {Factor,        SolveGeneral,         SolveLowerColumns, Product,
          SubtractThree, SubtractThreeRounded, AddThrees};
}

}  // namespace hazumi

#include "engine/spatial/lanes/avx2_end.h"
