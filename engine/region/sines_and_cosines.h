#pragma once

#include <vector>

#include "engine/spatial/lanes/lane_array.h"

namespace hazumi {

// Sines and cosines of the angles of a state, four at a time.
class SinesAndCosines {
 public:
  // At most `count` angles.
  explicit SinesAndCosines(int count) : sines_(Padded(count)), cosines_(Padded(count)) {}

  // Of the angles state[from[0]], state[from[1]], ... [rad].
  void Set(const double* state, const std::vector<int>& from);

  double sine(int i) const { return sines_.data()[i]; }
  double cosine(int i) const { return cosines_.data()[i]; }

 private:
  static size_t Padded(int count) { return (count + kMaxLanes - 1) / kMaxLanes * kMaxLanes; }

  LaneArray sines_, cosines_;
};

}  // namespace hazumi
