#pragma once

#include <string_view>

namespace hazumi {

// Seconds a frame as written in a file, such as 0.0416667, made the exact 1/fps that was meant.
struct SnappedFrameTime {
  double seconds = 0.0;
  bool was_coarse = false;  // meant is a guess from few digits, such as 1/30 from 0.033
};

// A whole rate up to 1000, or one of those of television (30000/1001 and its like), within 1e-4 of
// the time written; else a usual rate whose time, rounded or cut to as many digits, is the one
// written; else the time as it is. `seconds` is what `written` says and positive.
SnappedFrameTime SnapFrameTime(double seconds, std::string_view written);

}  // namespace hazumi
