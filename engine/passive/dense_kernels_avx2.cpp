#include "engine/passive/dense_kernels.h"

// The same loops for processors with AVX2. Everything above is compiled without it, so that no
// function of a shared header is.

#if defined(__x86_64__)
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC target("avx2")
#endif
#endif

namespace hazumi {

namespace {
#include "engine/passive/dense_loops.h"
}  // namespace

DenseKernels Avx2DenseKernels() {
  return {Factor, SolveLowerColumns, Product, DotThree, SubtractThree, SubtractThreeRounded};
}

}  // namespace hazumi

#if defined(__x86_64__) && defined(__clang__)
#pragma clang attribute pop
#endif
