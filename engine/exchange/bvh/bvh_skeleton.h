#pragma once

#include <vector>

#include "engine/base/result.h"
#include "engine/base/warning.h"
#include "engine/exchange/bvh/bvh_names.h"
#include "engine/exchange/bvh/bvh_scanner.h"
#include "engine/exchange/character/character.h"

namespace hazumi {

// Bounds that no animator meets; they keep a broken file from taking all memory.
inline constexpr int kMaxBvhJoints = 4096;
inline constexpr int kMaxBvhDepth = 256;      // joints inside one another
inline constexpr double kMaxBvhLength = 1e8;  // unit of the file

struct BvhSkeleton {
  std::vector<Bone> bones;
  std::vector<int> lines;            // of the bones, in the file
  std::vector<BvhChannel> channels;  // in the order of the motion's columns
};

// The part of the file from HIERARCHY to the word MOTION, which is read as well. Errors name a
// line.
Result<BvhSkeleton> ReadBvhSkeleton(BvhScanner* scanner, std::vector<Warning>* warnings);

}  // namespace hazumi
