#include "engine/analysis/lanes/cone_lanes.h"

// The filter of low_pass.cpp, forwards and then backwards, a series in each lane.

// From rest at the first sample on, each of which is `stride` numbers further.
HAZUMI_LANE_INLINE void Pass(const LowPassFilter& filter, long count, long stride, double* at) {
  const LaneReal b = All(filter.b), a1 = All(filter.a1), a2 = All(filter.a2);
  constexpr int kHalves = kFiltered / 4;  // which do not wait for each other
  LaneReal x1[kHalves], x2[kHalves], y1[kHalves], y2[kHalves];
  for (int k = 0; k < kHalves; ++k) x1[k] = x2[k] = y1[k] = y2[k] = Load<4>(at + 4 * k);
  for (long n = 1; n < count; ++n) {
    at += stride;
    for (int k = 0; k < kHalves; ++k) {
      const LaneReal x = Load<4>(at + 4 * k);
      const LaneReal y = b * (x + 2.0 * x1[k] + x2[k]) - a1 * y1[k] - a2 * y2[k];
      Store<4>(at + 4 * k, y);
      x2[k] = x1[k];
      x1[k] = x;
      y2[k] = y1[k];
      y1[k] = y;
    }
  }
}

void LowPassSeries(const LowPassFilter& filter, long count, double* series) {
  Pass(filter, count, kFiltered, series);
  Pass(filter, count, -kFiltered, series + (count - 1) * kFiltered);
  LeaveLanes();
}

HAZUMI_LANE_INLINE LaneReal LoadUnaligned(const double* at) {
  LaneReal value;
  __builtin_memcpy(&value, at, sizeof value);
  return value;
}

// smooth_motion.cpp has the equations.
void Differentiate(const double* x, long count, long stride, double h, double* rates,
                   double* accelerations) {
  const double per_2h = 0.5 / h, per_h2 = 1.0 / (h * h);
  long i = 0;
  for (; i + 4 <= count; i += 4) {
    const LaneReal before = LoadUnaligned(x + i - stride), after = LoadUnaligned(x + i + stride);
    const LaneReal rate = per_2h * (after - before);
    const LaneReal acceleration = per_h2 * (after - 2.0 * LoadUnaligned(x + i) + before);
    __builtin_memcpy(rates + i, &rate, sizeof rate);
    __builtin_memcpy(accelerations + i, &acceleration, sizeof acceleration);
  }
  for (; i < count; ++i) {
    rates[i] = per_2h * (x[i + stride] - x[i - stride]);
    accelerations[i] = per_h2 * (x[i + stride] - 2.0 * x[i] + x[i - stride]);
  }
  LeaveLanes();
}
