#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace hazumi {

// Of whole numbers, well mixed.
template <typename... Numbers>
uint64_t HashOf(Numbers... numbers) {
  uint64_t sum = 0;
  const auto add = [&sum](uint64_t number) {
    sum = (sum + number + 0x9e3779b97f4a7c15) * 0xbf58476d1ce4e5b9;
    sum ^= sum >> 29;
  };
  (add(static_cast<uint64_t>(numbers)), ...);
  return sum;
}
// One bit of 64, so that what happens several times happens once.
inline uint64_t BitOf(uint64_t hash) { return uint64_t{1} << (HashOf(hash) >> 58); }

// Events that follow each other more closely than this are one: their order means nothing [s].
constexpr double kOneEvent = 2e-3;

// What happened from `time` to `last_time` [s], as sums that are the same for the same events: of
// limits that were hit and things that touched down or broke, in any order, and of what holds, what
// sticks and what slides from then on.
struct EventMark {
  double time = 0.0, last_time = 0.0;
  uint64_t happened = 0, state = 0;
};

// The events of a solution in their order. Two solutions of one motion whose events differ are on
// different branches of it: how near they are tells nothing of what is right from there on.
// [METHOD 8.2]
class EventTrail {
 public:
  // Joins marks that are one.
  void Add(const EventMark& mark) {
    if (marks_.empty() || mark.time - marks_.back().last_time > kOneEvent) {
      // What changes nothing is no event.
      const uint64_t state = marks_.empty() ? 0 : marks_.back().state;
      if (mark.happened != 0 || mark.state != state) marks_.push_back(mark);
      return;
    }
    marks_.back().last_time = mark.last_time;
    marks_.back().happened |= mark.happened;
    marks_.back().state = mark.state;
  }

  // From when on the two differ, as far as that is certain at t, up to which both are known [s]:
  // one of them may not have come yet to an event that the other one has had.
  static std::optional<double> Part(const EventTrail& a, const EventTrail& b, double t) {
    const size_t count = std::max(a.marks_.size(), b.marks_.size());
    for (size_t i = 0; i < count; ++i) {
      const EventMark& one = i < a.marks_.size() ? a.marks_[i] : b.marks_[i];
      const EventMark& other = i < b.marks_.size() ? b.marks_[i] : a.marks_[i];
      const bool are_both_there = &one != &other;
      if (are_both_there && one.happened == other.happened && one.state == other.state) continue;
      const bool is_over = std::max(one.last_time, other.last_time) < t - 2.0 * kOneEvent;
      return is_over ? std::optional(std::min(one.time, other.time)) : std::nullopt;
    }
    return std::nullopt;
  }

 private:
  std::vector<EventMark> marks_;
};

}  // namespace hazumi
