#pragma once

#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/warning.h"
#include "engine/exchange/bvh/bvh_scanner.h"
#include "engine/exchange/bvh/bvh_skeleton.h"
#include "engine/exchange/content.h"

namespace hazumi {

inline constexpr int kMaxBvhFrames = 1'000'000;
inline constexpr size_t kMaxBvhValues = 20'000'000;
inline constexpr double kMaxBvhAngle = 1e7;  // degrees

struct BvhMotion {
  double seconds_per_frame = 0.0;
  int num_frames = 0;
  std::vector<double> values;  // frame after frame, a value a channel: unit of the file or degrees
};

// What follows the word MOTION. There is at least one frame; the rows that are there count, not
// what Frames says.
Result<BvhMotion> ReadBvhMotion(const BvhSkeleton& skeleton, const ReadChoice& choice,
                                BvhScanner* scanner, std::vector<Warning>* warnings);

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
