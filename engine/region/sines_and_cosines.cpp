#include "engine/region/sines_and_cosines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hazumi {

namespace {
#include "engine/spatial/lanes/lane_trig.h"
}  // namespace

void SinesAndCosines::Set(const double* state, const std::vector<int>& from) {
  const int count = static_cast<int>(from.size());
  for (int i = 0; i < count; i += kMaxLanes) {
    int lane[kMaxLanes];  // the last angle fills up
    for (int l = 0; l < kMaxLanes; ++l) lane[l] = from[std::min(i + l, count - 1)];
    const LanesOf<4>::Real angles = Collect(state, lane);
    LanesOf<4>::Real sines, cosines;
    SineAndCosine<4>(angles, &sines, &cosines);
    Store<4>(sines_.data() + i, sines);
    Store<4>(cosines_.data() + i, cosines);
    if (!AnySet(IsLarge<4>(angles))) continue;
    for (int l = 0; l < kMaxLanes; ++l) {
      sines_.data()[i + l] = std::sin(state[lane[l]]);
      cosines_.data()[i + l] = std::cos(state[lane[l]]);
    }
  }
}

}  // namespace hazumi
