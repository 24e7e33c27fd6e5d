#include "ui/edit/operators/keys/key_rates.h"

#include <algorithm>
#include <cmath>

#include "engine/timeline/curve_track.h"
#include "ui/edit/operators/edits.h"

namespace hazumi::edit {

namespace {

FrameRate RateOf(const ProjectRate& fps) { return {fps.num, fps.den}; }

bool HasOwnShape(const ProjectKey& left, const ProjectKey& right) {
  if (IsEased(left.interpolation)) return true;
  return left.interpolation == Interpolation::kCubic && (left.length_out || right.length_in);
}

}  // namespace

std::vector<RatesOfKey> RatesOf(const ProjectCurve& curve, const ProjectRate& fps) {
  const Keys keys = ToKeys(curve, 1.0);
  CurveTrack track(&keys, RateOf(fps), 0.0, {});
  std::vector<RatesOfKey> rates;
  for (const Key& key : keys) {
    rates.push_back({track.Before(key.frame).rate, track.At(key.frame).rate});
  }
  return rates;
}

void ToCubicsAround(double frame, const ProjectRate& fps, ProjectCurve* curve) {
  const auto later = [](double f, const ProjectKey& key) { return f < key.frame; };
  const auto next = std::upper_bound(curve->keys.begin(), curve->keys.end(), frame, later);
  if (next == curve->keys.begin() || next == curve->keys.end()) return;
  const size_t left = next - curve->keys.begin() - 1;
  if (curve->keys[left].frame == frame || !HasOwnShape(curve->keys[left], *next)) return;
  const double first = curve->keys[left].frame, last = next->frame;
  const Keys keys = ToKeys(*curve, 1.0);
  CurveTrack track(&keys, RateOf(fps), 0.0, {});
  ProjectKey* from = &curve->keys[left];
  from->rate_in = track.Before(first).rate;
  from->rate = track.At(first).rate;
  from->interpolation = Interpolation::kCubic;
  from->length_out.reset();
  ProjectKey* to = from + 1;
  to->rate = to->rate.value_or(track.At(last).rate);
  to->rate_in = track.Before(last).rate;
  to->length_in.reset();
  for (double f = std::floor(first) + 1.0; f < last; f += 1.0) {
    ProjectKey key;
    key.frame = f;
    key.value = WithoutRoundOff(track.At(f).value);
    key.rate = WithoutRoundOff(track.At(f).rate);
    PutKey(key, curve);
  }
}

}  // namespace hazumi::edit
