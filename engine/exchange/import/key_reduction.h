#pragma once

// Internal. A curve given frame by frame as few keys.

#include <vector>

namespace hazumi {

// A key with its rate; cubics between them.
struct ReducedKey {
  int frame = 0;
  double value = 0.0, rate = 0.0;  // rate: per frame
};

// Keys on some of the frames 0, 1, ..., the first and the last among them, whose cubics stay within
// `tolerance` of every value. Rates are those of the parabola through a value and its neighbours.
std::vector<ReducedKey> ReduceKeys(const std::vector<double>& values, double tolerance);

// What these keys say at every frame from the first to the last.
std::vector<double> ValuesOf(const std::vector<ReducedKey>& keys);

}  // namespace hazumi
