#include <cstdint>

#include "engine/dynamics/lane_kernels.h"

// The same sweeps for processors with AVX2. Everything above is compiled without it, so that no
// function of a shared header is.

#if defined(__x86_64__)
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2"))), apply_to = function)
#else
#pragma GCC target("avx2")
#endif
#define HAZUMI_VECTORS_OF_FOUR
#endif

namespace hazumi {

namespace {
#include "engine/dynamics/lane_sweeps.h"
}  // namespace

LaneKernels Avx2Kernels(int width) {
  if (width == 1) return {Start<1>, Torques<1>};
  return {Start<4>, Torques<4>};
}

}  // namespace hazumi

#if defined(__x86_64__) && defined(__clang__)
#pragma clang attribute pop
#endif
