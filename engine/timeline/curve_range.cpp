// Between two keys a curve has its extremes where its rate changes sign, of an eased one also where
// it bounces off: looked for between instants so close together that none passes two of them that
// are far apart, and found by halving.

#include "engine/timeline/curve_track.h"

namespace hazumi {

namespace {

constexpr int kLooks = 64;     // between two keys
constexpr int kHalvings = 50;  // down to rounding

void Include(double frame, double value, CurveRange* range) {
  if (value < range->least) {
    range->least = value;
    range->frame_of_least = frame;
  }
  if (value > range->greatest) {
    range->greatest = value;
    range->frame_of_greatest = frame;
  }
}

// Where its rate changes sign from that at `from`.
double Extreme(CurveTrack* track, double from, double to) {
  const bool rises = track->At(from).rate > 0.0;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (from + to);
    ((track->At(middle).rate > 0.0) == rises ? from : to) = middle;
  }
  return from;
}

void IncludeBetween(CurveTrack* track, double first, double last, CurveRange* range) {
  double before = first;
  for (int i = 1; i <= kLooks; ++i) {
    const double frame = i < kLooks ? first + (last - first) * i / kLooks : last;
    const CurveSample from = track->At(before), to = track->Before(frame);
    Include(frame, to.value, range);
    if (from.rate * to.rate < 0.0) {
      const double extreme = Extreme(track, before, frame);
      Include(extreme, track->At(extreme).value, range);
    }
    before = frame;
  }
}

}  // namespace

CurveRange RangeOf(const Keys& keys, FrameRate rate) {
  const Key& first = keys.front();
  CurveRange range{first.value, first.value, first.frame, first.frame};
  CurveTrack track(&keys, rate, 0.0, {});
  for (size_t i = 1; i < keys.size(); ++i) {
    Include(keys[i].frame, keys[i].value, &range);
    IncludeBetween(&track, keys[i - 1].frame, keys[i].frame, &range);
  }
  return range;
}

}  // namespace hazumi
