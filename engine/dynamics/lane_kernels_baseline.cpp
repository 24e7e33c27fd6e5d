#include <cstdint>

#include "engine/dynamics/lane_kernels.h"

// The sweeps for any processor.

namespace hazumi {

namespace {
#include "engine/dynamics/lane_sweeps.h"
}  // namespace

LaneKernels BaselineKernels(int width) {
  if (width == 1) return {Start<1>, Torques<1>};
  return {Start<4>, Torques<4>};
}

bool CpuHasAvx2() {
#if defined(__x86_64__)
  return __builtin_cpu_supports("avx2") != 0;
#else
  return false;
#endif
}

}  // namespace hazumi
