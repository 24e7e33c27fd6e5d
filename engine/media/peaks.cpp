#include "engine/media/peaks.h"

#include <algorithm>
#include <cmath>

namespace hazumi {

Peaks::Peaks(const Sound& sound) : rate_(sound.format.rate) {
  std::vector<Pair> level;
  const auto channels = static_cast<size_t>(sound.format.channels);
  level.reserve(sound.samples.size() / channels);
  for (size_t i = 0; i + channels <= sound.samples.size(); i += channels) {
    level.push_back({sound.samples[i], sound.samples[i]});
  }
  while (!level.empty()) {
    std::vector<Pair> coarser;
    coarser.reserve(level.size() / 2);
    for (size_t i = 0; i + 1 < level.size(); i += 2) {
      coarser.push_back(
          {std::min(level[i].low, level[i + 1].low), std::max(level[i].high, level[i + 1].high)});
    }
    levels_.push_back(std::move(level));
    level = std::move(coarser);
  }
}

double Peaks::seconds() const {
  return levels_.empty() ? 0.0 : static_cast<double>(levels_[0].size()) / rate_;
}

Peaks::Range Peaks::In(double from, double to) const {
  if (levels_.empty()) return {};
  const auto count = static_cast<double>(levels_[0].size());
  const double first = std::floor(from * rate_);
  const double last = std::max(std::ceil(to * rate_), first + 1.0);
  if (last <= 0.0 || first >= count) return {};
  auto i = static_cast<size_t>(std::max(first, 0.0));
  const auto end = static_cast<size_t>(std::min(last, count));
  Pair pair = levels_[0][i];
  while (i < end) {
    // The largest block that begins here and ends in time.
    size_t level = 0;
    while (level + 1 < levels_.size() && i % (size_t{2} << level) == 0 &&
           i + (size_t{2} << level) <= end) {
      ++level;
    }
    const Pair& block = levels_[level][i >> level];
    pair = {std::min(pair.low, block.low), std::max(pair.high, block.high)};
    i += size_t{1} << level;
  }
  constexpr float kFull = 32768.0f;
  return {static_cast<float>(pair.low) / kFull, static_cast<float>(pair.high) / kFull};
}

}  // namespace hazumi
