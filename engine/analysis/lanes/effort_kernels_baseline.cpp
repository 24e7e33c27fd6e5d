#include <cstdint>

#include "engine/analysis/lanes/effort_kernels.h"

// For any processor.

namespace hazumi {

namespace {
#include "engine/analysis/lanes/strength_lanes.h"
}  // namespace

EffortKernels BaselineEffortKernels() {
  return {Place, Demand, Relay, Touch, Supply, Solve, Share, LowPassSeries, Differentiate};
}

}  // namespace hazumi
