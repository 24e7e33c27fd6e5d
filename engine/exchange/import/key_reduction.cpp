#include "engine/exchange/import/key_reduction.h"

#include <algorithm>
#include <cmath>

#include "engine/timeline/interval.h"

namespace hazumi {

namespace {

double RateAt(const std::vector<double>& values, int frame) {
  const int last = static_cast<int>(values.size()) - 1;
  if (last < 1) return 0.0;
  if (last == 1) return values[1] - values[0];
  if (frame == 0) return -1.5 * values[0] + 2.0 * values[1] - 0.5 * values[2];
  if (frame == last) return 1.5 * values[last] - 2.0 * values[last - 1] + 0.5 * values[last - 2];
  return 0.5 * (values[frame + 1] - values[frame - 1]);
}

Interval Between(const ReducedKey& a, const ReducedKey& b) {
  return Interval::Cubic(a.value, a.rate, b.value, b.rate, b.frame - a.frame);
}

}  // namespace

std::vector<ReducedKey> ReduceKeys(const std::vector<double>& values, double tolerance) {
  const auto key_at = [&](int frame) {
    return ReducedKey{frame, values[frame], RateAt(values, frame)};
  };
  std::vector<ReducedKey> keys = {key_at(0)};
  // Ends of the spans that are left to do, the next one last.
  std::vector<int> ends;
  if (values.size() > 1) ends.push_back(static_cast<int>(values.size()) - 1);
  while (!ends.empty()) {
    const ReducedKey& from = keys.back();
    const ReducedKey to = key_at(ends.back());
    const Interval cubic = Between(from, to);
    int worst = 0;
    double most = tolerance;
    for (int f = from.frame + 1; f < to.frame; ++f) {
      const double off = std::abs(cubic.At(f - from.frame).value - values[f]);
      if (off <= most) continue;
      most = off;
      worst = f;
    }
    if (worst > 0) {
      ends.push_back(worst);
    } else {
      keys.push_back(to);
      ends.pop_back();
    }
  }
  return keys;
}

std::vector<double> ValuesOf(const std::vector<ReducedKey>& keys) {
  std::vector<double> values = {keys.front().value};
  for (size_t k = 1; k < keys.size(); ++k) {
    const Interval cubic = Between(keys[k - 1], keys[k]);
    const int length = keys[k].frame - keys[k - 1].frame;
    for (int f = 1; f < length; ++f) values.push_back(cubic.At(f).value);
    values.push_back(keys[k].value);
  }
  return values;
}

}  // namespace hazumi
