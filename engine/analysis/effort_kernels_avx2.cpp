#include <cstdint>

#include "engine/analysis/effort_kernels.h"

// For processors with AVX2. Everything above is compiled without it, so that no function of a
// shared header is.

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
#include "engine/analysis/cone_lanes.h"
}  // namespace

EffortKernels Avx2EffortKernels() { return {Place, Supply}; }

}  // namespace hazumi

#if defined(__x86_64__) && defined(__clang__)
#pragma clang attribute pop
#endif
