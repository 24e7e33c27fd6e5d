#include "engine/makers/fills/generated_keys.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/project/edits/keys.h"
#include "engine/timeline/curve_track.h"

namespace hazumi::makers {

namespace {

// Slope at an entry, per frame; at the ends that of the parabola through three.
double SlopeAt(const std::vector<double>& values, size_t i) {
  const size_t last = values.size() - 1;
  if (last == 0) return 0.0;
  if (last == 1) return values[1] - values[0];
  if (i == 0) return -1.5 * values[0] + 2.0 * values[1] - 0.5 * values[2];
  if (i == last) return 1.5 * values[last] - 2.0 * values[last - 1] + 0.5 * values[last - 2];
  return 0.5 * (values[i + 1] - values[i - 1]);
}

// Whether a fill may put a key on a frame.
bool MayHaveKey(double frame, const ProjectCurve& curve) {
  const auto next = std::upper_bound(curve.keys.begin(), curve.keys.end(), frame,
                                     [](double f, const ProjectKey& key) { return f < key.frame; });
  if (next == curve.keys.begin() || next == curve.keys.end()) return true;
  return MayBeFilled(std::prev(next)->interpolation);
}

}  // namespace

// Adds a key where an interval between two keys is farthest off, until none is.
int PutGeneratedKeys(const std::vector<double>& values, int first, const ProjectRate& fps,
                     double tolerance, ProjectCurve* curve) {
  const double per_second = static_cast<double>(fps.num) / fps.den;
  int count = 0;
  const auto put = [&](size_t i) {
    ProjectKey key;
    key.frame = first + static_cast<int>(i);
    key.value = WithoutRoundOff(values[i]);
    key.rate = WithoutRoundOff(SlopeAt(values, i) * per_second);
    key.type = KeyType::kGenerated;
    PutKey(key, curve);
    ++count;
  };
  for (const size_t i : {size_t{0}, values.size() - 1}) {
    const int frame = first + static_cast<int>(i);
    if (!KeyOn(frame, *curve) && MayHaveKey(frame, *curve)) put(i);
  }
  for (bool is_done = false; !is_done;) {
    const Keys keys = ToKeys(*curve, 1.0);
    CurveTrack track(&keys, {fps.num, fps.den}, 0.0, {});
    std::vector<size_t> farthest;
    size_t worst = 0;
    double most = tolerance;
    for (size_t i = 1; i < values.size(); ++i) {
      const double frame = first + static_cast<int>(i);
      if (track.KeyAt(frame)) {
        if (most > tolerance) farthest.push_back(worst);
        most = tolerance;
        continue;
      }
      const double off = std::abs(track.At(frame).value - values[i]);
      if (!(off > most)) continue;
      most = off;
      worst = i;
    }
    for (const size_t i : farthest) put(i);
    is_done = farthest.empty();
  }
  return count;
}

}  // namespace hazumi::makers
