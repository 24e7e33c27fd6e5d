#pragma once

#include <cstdint>
#include <vector>

#include "engine/media/decode_sound.h"

namespace hazumi {

// How loud a sound is over time, for pictures of its wave at any zoom: the lowest and the highest
// sample of any stretch, found among few numbers.
class Peaks {
 public:
  // Of the first channel.
  explicit Peaks(const Sound& sound);

  struct Range {
    float low = 0.0f, high = 0.0f;  // 1: as loud as a file can be
    bool operator==(const Range&) const = default;
  };
  // Of the samples from one instant to another [s since the beginning], the one that sounds at
  // `from` always among them. Outside of the sound it is silent.
  Range In(double from, double to) const;
  double seconds() const;

 private:
  struct Pair {
    std::int16_t low, high;
  };
  double rate_;
  // Of blocks of 1, 2, 4 ... samples. What a level has no whole block of is left to those before.
  std::vector<std::vector<Pair>> levels_;
};

}  // namespace hazumi
