#pragma once

#include "engine/analysis/lanes/effort_kernels.h"
#include "engine/spatial/types.h"

namespace hazumi {

// Takes what is faster than `cutoff` [Hz] out of series, one a row, with samples `dt` [s] apart in
// the columns; nothing is delayed. Series of one sample, and a cutoff that the samples cannot show
// (at or above half of their rate), are left as they are.
void LowPass(double cutoff, double dt, MatX* series,
             const EffortKernels& kernels = BestEffortKernels());

}  // namespace hazumi
