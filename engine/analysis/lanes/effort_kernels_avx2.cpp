#include <cstdint>

#include "engine/analysis/lanes/effort_kernels.h"

// For processors with AVX2.

#include "engine/spatial/lanes/avx2_begin.h"

namespace hazumi {

namespace {
#include "engine/analysis/lanes/strength_lanes.h"
}  // namespace

EffortKernels Avx2EffortKernels() {
  return {Place, Demand, Relay, Touch, Supply, Solve, Share, LowPassSeries, Differentiate};
}

}  // namespace hazumi

#include "engine/spatial/lanes/avx2_end.h"
