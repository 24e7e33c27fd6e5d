#pragma once

#include <vector>

#include "engine/timeline/frame_time.h"
#include "engine/timeline/interval.h"
#include "engine/timeline/keyframe.h"
#include "engine/timeline/spline_run.h"

namespace hazumi {

// One curve while it is being baked. It follows its keys until something else takes over (a
// dynamics region, inverse kinematics, a placement) and goes on from where that left it.
//
// Rules, from left to right:
// - Before the first key and after the last one the curve is constant.
// - An interval starts with its left key's rate if given, else with the rate at which the interval
//   before ended; the first key starts at rate 0.
// - A cubic arrives with the right key's rate if given (`rate_in` before `rate`), else with an
//   automatic tangent: between two neighbours as AutomaticRate, at the last key flat.
// - Intervals of least acceleration or jerk that follow each other are one run, up to a key that
//   states a rate or on which something takes over. A run begins as any interval does, but free
//   where the first key of the curve states no rate; it ends with the right key's rate if given,
//   free at the last key or a takeover, and else with an automatic tangent. On the way out of a
//   takeover such an interval is a cubic.
// - Tangents have their lengths between two keys alone, not on the way out of a takeover.
// - At a key on which a takeover begins the keys beyond it say nothing, so the tangent there is
//   that of a parabola [Arai 2.5 (1)]: marking a region lets the limb go with the speed that its
//   keys built up.
// - Except in a recording, where the keys before and after that one are at most a frame away: there
//   the tangent is the slope between those two, the rate that was recorded. The parabola would pass
//   the error of each key on, and it overshoots just beyond an extreme.
class CurveTrack {
 public:
  // `keys` must outlive the track. `takeovers`: the frames at which something else takes over.
  CurveTrack(const Keys* keys, FrameRate rate, double default_value, std::vector<double> takeovers);

  // At a key and at a resumption: the limit from the right.
  CurveSample At(double frame);
  // The limit from the left, if something lies there; else as At.
  CurveSample Before(double frame);
  // What runs through `frame`, or begins there: from first_frame (-infinity before the first key)
  // to last_frame.
  struct Piece {
    double first_frame, last_frame;
    Interval interval;
    bool operator==(const Piece&) const = default;
  };
  Piece PieceAt(double frame);
  // What leads to `frame`.
  Piece PieceBefore(double frame);
  // Goes on from a piece, as if it had got there by itself.
  void Restart(const Piece& piece) { segments_ = {piece}; }
  // The key that lies exactly on `frame`, or null.
  const Key* KeyAt(double frame) const;
  bool HasKeyAfter(double frame) const;

  // Goes on from `frame` with this value and rate to the next key after it; what was planned from
  // there on is forgotten. The first interval is a cubic unless `as_keyed` is set and a key lies on
  // `frame`: then it is of that key's kind.
  void Resume(double frame, double value, double rate, bool as_keyed = false);
  // As Resume, by one cubic to BlendTarget(until), where it arrives with the rate that the keys
  // have there by themselves; those between are passed over. For until > frame.
  void Blend(double frame, double value, double rate, double until);
  // The first key at or after `until`; if there is none the constant after the last key, at
  // `until`.
  struct Target {
    double frame, value;
  };
  Target BlendTarget(double until) const;

 private:
  using Segment = Piece;

  void PlanUpTo(double frame);
  // Appends the segment of a run after the key `left`, where the last segment ends.
  void AppendOfRun(double rate, const Key& left);
  const SplineRun& RunThrough(size_t index);
  bool GoesOnThrough(size_t index) const;
  // Up to the next key; `left`: of whose kind, null for a cubic of its own.
  void Append(double frame, double value, double rate, const Key* left);
  double ArrivalRate(const Key& target, size_t index, double start_frame, double start_value,
                     double start_rate) const;
  double AutomaticArrival(size_t index, double left_frame, double left_value) const;
  bool IsTakenOver(double frame) const;
  bool IsRecorded(size_t index, double left_frame) const;
  void CutAt(double frame);
  double LastValue() const { return keys_->empty() ? default_value_ : keys_->back().value; }
  CurveSample Evaluate(const Segment& segment, double frame) const;
  double Seconds(double frames) const { return rate_.SecondsAt(frames); }

  const Keys* keys_;
  FrameRate rate_;
  double default_value_;
  std::vector<double> takeovers_;  // ascending
  std::vector<Segment> segments_;
  std::vector<SplineRun> runs_;  // that were asked for
};

// Between which values a curve stays, and the frames at which it is there.
struct CurveRange {
  double least = 0.0, greatest = 0.0;
  double frame_of_least = 0.0, frame_of_greatest = 0.0;
};

// Returns the range of a curve, which may go further between its keys than any of them. Requires at
// least one key, and that nothing takes the curve over.
CurveRange RangeOf(const Keys& keys, FrameRate rate);

}  // namespace hazumi
