#include <cstdint>

#include "engine/dynamics/lane_kernels.h"

// For processors with AVX2.

#include "engine/dynamics/avx2_begin.h"

namespace hazumi {

namespace {
#include "engine/dynamics/lane_sweeps.h"
}  // namespace

LaneKernels Avx2Kernels(int width) {
  if (width == 1) return {Start<1>, Torques<1>};
  return {Start<4>, Torques<4>};
}

}  // namespace hazumi

#include "engine/dynamics/avx2_end.h"
