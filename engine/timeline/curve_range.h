#pragma once

#include "engine/timeline/frame_time.h"
#include "engine/timeline/keyframe.h"

namespace hazumi {

// Between which values a curve stays, and the frames at which it is there.
struct CurveRange {
  double least = 0.0, greatest = 0.0;
  double frame_of_least = 0.0, frame_of_greatest = 0.0;
};

// Of keys that nothing takes over, of which there is at least one: between its keys a curve may go
// further than any of them. All keys as they are if the curve is constant.
CurveRange RangeOf(const Keys& keys, FrameRate rate);

}  // namespace hazumi
