#include <cstdint>

#include "engine/analysis/effort_kernels.h"

// For any processor.

namespace hazumi {

namespace {
#include "engine/analysis/cone_lanes.h"
}  // namespace

EffortKernels BaselineEffortKernels() { return {Place, Demand, Relay, Touch, Supply}; }

}  // namespace hazumi
