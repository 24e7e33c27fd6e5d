#include "engine/project/edits/keys.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/project/project_curve.h"
#include "engine/timeline/curve_track.h"

namespace hazumi {

namespace {

FrameRate RateOf(const ProjectRate& fps) { return {fps.num, fps.den}; }

bool HasOwnShape(const ProjectKey& left, const ProjectKey& right) {
  if (IsEased(left.interpolation)) return true;
  return left.interpolation == Interpolation::kCubic && (left.length_out || right.length_in);
}

}  // namespace

ProjectKey* KeyOn(double frame, ProjectCurve* curve) {
  return const_cast<ProjectKey*>(KeyOn(frame, std::as_const(*curve)));
}

const ProjectKey* KeyOn(double frame, const ProjectCurve& curve) {
  const auto key = std::lower_bound(curve.keys.begin(), curve.keys.end(), frame,
                                    [](const ProjectKey& k, double f) { return k.frame < f; });
  return key != curve.keys.end() && key->frame == frame ? &*key : nullptr;
}

ProjectKey KeyToChange(double frame, const ProjectCurve& curve) {
  const ProjectKey* there = KeyOn(frame, curve);
  ProjectKey key = there ? *there : ProjectKey();
  key.frame = frame;
  if (key.type == KeyType::kGenerated) {
    key.type = KeyType::kKeyframe;
    SetAutomatic(&key);
  }
  return key;
}

void PutKey(const ProjectKey& key, ProjectCurve* curve) {
  if (ProjectKey* there = KeyOn(key.frame, curve)) {
    ExtraFields extra = std::move(there->extra);
    *there = key;
    if (key.extra.empty()) there->extra = std::move(extra);
    return;
  }
  const auto is_before = [](const ProjectKey& a, const ProjectKey& b) { return a.frame < b.frame; };
  curve->keys.insert(std::lower_bound(curve->keys.begin(), curve->keys.end(), key, is_before), key);
}

void RemoveKeysIn(int first, int last, ProjectCurve* curve) {
  std::erase_if(curve->keys,
                [&](const ProjectKey& key) { return key.frame >= first && key.frame <= last; });
}

void SetAutomatic(ProjectKey* key) {
  key->rate.reset();
  key->rate_in.reset();
  key->length_in.reset();
  key->length_out.reset();
}

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

}  // namespace hazumi
