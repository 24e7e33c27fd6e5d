#include "engine/timeline/curve_track.h"

#include <algorithm>
#include <limits>

namespace hazumi {

namespace {

constexpr double kEver = std::numeric_limits<double>::infinity();
constexpr double kThird = 1.0 / 3.0;

size_t FirstAfter(const Keys& keys, double frame) {
  const auto later = [](double f, const Key& key) { return f < key.frame; };
  return std::upper_bound(keys.begin(), keys.end(), frame, later) - keys.begin();
}

size_t FirstNotBefore(const Keys& keys, double frame) {
  const auto earlier = [](const Key& key, double f) { return key.frame < f; };
  return std::lower_bound(keys.begin(), keys.end(), frame, earlier) - keys.begin();
}

}  // namespace

CurveTrack::CurveTrack(const Keys* keys, FrameRate rate, double default_value,
                       std::vector<double> takeovers)
    : keys_(keys), rate_(rate), default_value_(default_value), takeovers_(std::move(takeovers)) {
  std::sort(takeovers_.begin(), takeovers_.end());
  const double start_value = keys->empty() ? default_value : keys->front().value;
  const double start_frame = keys->empty() ? kEver : keys->front().frame;
  segments_.push_back({-kEver, start_frame, Interval::Hold(start_value)});
}

const Key* CurveTrack::KeyAt(double frame) const {
  const size_t after = FirstAfter(*keys_, frame);
  if (after == 0 || (*keys_)[after - 1].frame != frame) return nullptr;
  return &(*keys_)[after - 1];
}

bool CurveTrack::HasKeyAfter(double frame) const {
  return FirstAfter(*keys_, frame) < keys_->size();
}

CurveSample CurveTrack::Evaluate(const Segment& segment, double frame) const {
  if (segment.first_frame == -kEver) return segment.interval.At(0.0);
  return segment.interval.At(Seconds(frame - segment.first_frame));
}

CurveSample CurveTrack::At(double frame) { return Evaluate(PieceAt(frame), frame); }

CurveTrack::Piece CurveTrack::PieceAt(double frame) {
  PlanUpTo(frame);
  size_t i = segments_.size() - 1;
  while (segments_[i].first_frame > frame) --i;
  return segments_[i];
}

CurveTrack::Piece CurveTrack::PieceBefore(double frame) {
  PlanUpTo(frame);
  size_t i = segments_.size() - 1;
  while (segments_[i].first_frame >= frame) --i;
  return segments_[i];
}

CurveSample CurveTrack::Before(double frame) { return Evaluate(PieceBefore(frame), frame); }

void CurveTrack::PlanUpTo(double frame) {
  while (segments_.back().last_frame <= frame) {
    const Segment& before = segments_.back();
    const Key* key = KeyAt(before.last_frame);
    if (!key) {  // a blend ends beyond the last key
      segments_.push_back({before.last_frame, kEver, Interval::Hold(LastValue())});
      continue;
    }
    const double rate = key->rate.value_or(Evaluate(before, before.last_frame).rate);
    if (IsOfRun(key->interpolation) && HasKeyAfter(key->frame)) {
      AppendOfRun(rate, *key);
    } else {
      Append(key->frame, key->value, rate, key);
    }
  }
}

void CurveTrack::CutAt(double frame) {
  while (segments_.size() > 1 && segments_.back().first_frame >= frame) segments_.pop_back();
  segments_.back().last_frame = frame;
}

void CurveTrack::Resume(double frame, double value, double rate, bool as_keyed) {
  CutAt(frame);
  Append(frame, value, rate, as_keyed ? KeyAt(frame) : nullptr);
}

CurveTrack::Target CurveTrack::BlendTarget(double until) const {
  const size_t index = FirstNotBefore(*keys_, until);
  if (index == keys_->size()) return {until, LastValue()};
  return {(*keys_)[index].frame, (*keys_)[index].value};
}

void CurveTrack::Blend(double frame, double value, double rate, double until) {
  CutAt(frame);
  const Target target = BlendTarget(until);
  const size_t index = FirstNotBefore(*keys_, until);
  double arrival = 0.0;
  if (index < keys_->size()) {
    const Key& key = (*keys_)[index];
    arrival = ArrivalRate(key, index, frame, value, rate);
    if (index > 0 && !key.rate_in && !key.rate && !IsTakenOver(key.frame)) {
      arrival = AutomaticArrival(index, (&key)[-1].frame, (&key)[-1].value);
    }
  }
  const double duration = Seconds(target.frame - frame);
  segments_.push_back(
      {frame, target.frame, Interval::Cubic(value, rate, target.value, arrival, duration)});
}

void CurveTrack::Append(double frame, double value, double rate, const Key* left) {
  const size_t next = FirstAfter(*keys_, frame);
  if (next == keys_->size()) {
    segments_.push_back({frame, kEver, Interval::Hold(value)});
    return;
  }
  const Key& target = (*keys_)[next];
  const double duration = Seconds(target.frame - frame);
  // Intervals that leave a takeover belong to no run.
  const bool is_single = left && !IsOfRun(left->interpolation);
  const Interpolation kind = is_single ? left->interpolation : Interpolation::kCubic;
  Interval interval = Interval::Hold(value);
  if (kind == Interpolation::kLinear) interval = Interval::Linear(value, target.value, duration);
  if (kind == Interpolation::kQuadratic) {
    interval = Interval::Quadratic(value, rate, target.value, duration);
  }
  if (kind == Interpolation::kCubic) {
    const double arrival = ArrivalRate(target, next, frame, value, rate);
    interval =
        left && (left->length_out || target.length_in)
            ? Interval::Weighted(value, rate, left->length_out.value_or(kThird), target.value,
                                 arrival, target.length_in.value_or(kThird), duration)
            : Interval::Cubic(value, rate, target.value, arrival, duration);
  }
  if (IsEased(kind)) {
    interval = Interval::Eased(value, target.value, duration, kind, left->easing);
  }
  segments_.push_back({frame, target.frame, interval});
}

// True if a run goes on through a key.
bool CurveTrack::GoesOnThrough(size_t index) const {
  if (index == 0 || index + 1 >= keys_->size()) return false;
  const Key &before = (*keys_)[index - 1], &key = (*keys_)[index];
  return IsOfRun(key.interpolation) && before.interpolation == key.interpolation && !key.rate &&
         !key.rate_in && !IsTakenOver(key.frame);
}

// The run that the interval after a key belongs to.
const SplineRun& CurveTrack::RunThrough(size_t index) {
  for (const SplineRun& run : runs_) {
    if (run.first() <= index && index < run.last()) return run;
  }
  size_t first = index, last = index + 1;
  while (GoesOnThrough(first)) --first;
  while (GoesOnThrough(last)) ++last;
  const Key& end = (*keys_)[last];
  std::optional<double> rate = end.rate_in ? end.rate_in : end.rate;
  if (!rate && last + 1 < keys_->size() && !IsTakenOver(end.frame)) {
    rate = AutomaticArrival(last, (*keys_)[last - 1].frame, (*keys_)[last - 1].value);
  }
  runs_.push_back(SplineRun(*keys_, first, last, (*keys_)[index].interpolation, rate_, rate));
  return runs_.back();
}

// The curve goes on with what the interval before ended with, wherever that began: the same bits
// after a restart.
void CurveTrack::AppendOfRun(double rate, const Key& left) {
  const size_t index = static_cast<size_t>(&left - keys_->data());
  const SplineRun& run = RunThrough(index);
  const Key& target = (&left)[1];
  const Segment& before = segments_.back();
  const bool is_inside = index > run.first() && before.last_frame == left.frame &&
                         before.first_frame == (&left)[-1].frame;
  SplineRun::State from;
  if (is_inside) {
    const CurveSample at = Evaluate(before, left.frame);
    from = {at.rate, at.acceleration};
  } else {
    const bool is_free = before.first_frame == -kEver && !left.rate;
    from = run.Begin(index, is_free ? std::nullopt : std::optional(rate));
  }
  const SplineRun::State to = run.Next(index, from);
  const double duration = Seconds(target.frame - left.frame);
  const bool is_jerk = left.interpolation == Interpolation::kLeastJerk;
  segments_.push_back(
      {left.frame, target.frame,
       is_jerk ? Interval::Quintic({left.value, from.rate, from.acceleration},
                                   {target.value, to.rate, to.acceleration}, duration)
               : Interval::Cubic(left.value, from.rate, target.value, to.rate, duration)});
}

double CurveTrack::ArrivalRate(const Key& target, size_t index, double start_frame,
                               double start_value, double start_rate) const {
  if (target.rate_in) return *target.rate_in;
  if (target.rate) return *target.rate;
  if (!IsTakenOver(target.frame)) return AutomaticArrival(index, start_frame, start_value);
  if (IsRecorded(index, start_frame)) {
    const Key& beyond = (*keys_)[index + 1];
    return (beyond.value - start_value) / Seconds(beyond.frame - start_frame);
  }
  return 2.0 * (target.value - start_value) / Seconds(target.frame - start_frame) - start_rate;
}

// At key number `index`, with what lies left of it.
double CurveTrack::AutomaticArrival(size_t index, double left_frame, double left_value) const {
  if (index + 1 == keys_->size()) return 0.0;
  const Key &key = (*keys_)[index], &beyond = (*keys_)[index + 1];
  return AutomaticRate(Seconds(left_frame), left_value, Seconds(key.frame), key.value,
                       Seconds(beyond.frame), beyond.value);
}

bool CurveTrack::IsTakenOver(double frame) const {
  return std::binary_search(takeovers_.begin(), takeovers_.end(), frame);
}

bool CurveTrack::IsRecorded(size_t index, double left_frame) const {
  const double frame = (*keys_)[index].frame;
  return frame - left_frame <= 1.0 && index + 1 < keys_->size() &&
         (*keys_)[index + 1].frame - frame <= 1.0;
}

}  // namespace hazumi
