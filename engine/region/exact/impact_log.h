#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/region/constraints/constraint_spec.h"
#include "engine/region/contact/contact_push.h"
#include "engine/region/exact/event_trail.h"
#include "engine/region/exact/limit_hits.h"

namespace hazumi {

// Smallest approach speed of a touch-down [m/s].
inline constexpr double kTouchDownSpeed = 1e-3;

// Touch-downs of a body: `count` of them from `time` to `last_time` [s].
struct TouchDown {
  double time = 0.0, last_time = 0.0;
  long count = 1;
  ContactParts parts;
  int ball = -1;  // held object that touched down; -1: a link
};

// Work of impacts [J], negative where energy is lost.
struct ImpactWork {
  // Work of impacts with contacts. Excludes impacts of limits alone, and contacts in time-stepping
  // mode (TimeStepping).
  double limits = 0.0, contacts = 0.0;
  bool has_contacts = false;
  void Add(const ImpactWork& other) {
    limits += other.limits;
    contacts += other.contacts;
    has_contacts |= other.has_contacts;
  }
};

// Events of an island between two reports, in order.
struct IslandEvents {
  std::vector<LimitHit> hits;
  std::vector<TouchDown> touches;
  std::vector<ConstraintBreak> breaks;  // by index of the island's constraints
  std::vector<EventMark> marks;         // of all of these
  ImpactWork impacts;

  void Append(const IslandEvents& later) {
    hits.insert(hits.end(), later.hits.begin(), later.hits.end());
    touches.insert(touches.end(), later.touches.begin(), later.touches.end());
    breaks.insert(breaks.end(), later.breaks.begin(), later.breaks.end());
    marks.insert(marks.end(), later.marks.begin(), later.marks.end());
    impacts.Add(later.impacts);
  }
};

// Impacts since the last report.
class ImpactLog {
 public:
  explicit ImpactLog(int num_hinges) : hits_(num_hinges) {}

  void AddHit(int hinge, double time) {
    happened_ |= BitOf(static_cast<uint64_t>(hinge));
    hits_.Add(hinge, time);
  }
  void AddWork(const ImpactWork& work) { work_.Add(work); }

  void AddTouch(const ContactParts& parts, int ball, double time) {
    happened_ |= BitOf(HashOf(parts.link, parts.object, parts.by_link, parts.by_ball, ball));
    const auto is_same = [&](const TouchDown& touch) {
      return touch.parts == parts && touch.ball == ball && time - touch.last_time < kChatterGap;
    };
    const auto last = std::find_if(touches_.rbegin(), touches_.rend(), is_same);
    if (last == touches_.rend()) return touches_.push_back({time, time, 1, parts, ball});
    last->count += time > last->last_time;  // several points of a link may touch down at once
    last->last_time = time;
  }
  // Notes that the events of the next mark could happen in another order.
  void NoteUnsure() { is_unsure_ = true; }
  // Adds a mark at `time` with the events since the last mark, and the state after them.
  void Mark(double time, uint64_t state) {
    marks_.push_back(
        {time, time, std::exchange(happened_, 0), state, std::exchange(is_unsure_, false)});
  }
  // Returns the events since the last call, without breaks, which constraints tell of.
  IslandEvents Take() {
    return {hits_.Take(),
            std::exchange(touches_, {}),
            {},
            std::exchange(marks_, {}),
            std::exchange(work_, {})};
  }

 private:
  LimitHits hits_;
  std::vector<TouchDown> touches_;
  ImpactWork work_;
  std::vector<EventMark> marks_;
  uint64_t happened_ = 0;
  bool is_unsure_ = false;
};

}  // namespace hazumi
