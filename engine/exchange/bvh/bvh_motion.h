#pragma once

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

}  // namespace hazumi
