#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace hazumi {

// Hash of integers.
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
// Returns one of 64 bits, so that repeated events count once.
inline uint64_t BitOf(uint64_t hash) { return uint64_t{1} << (HashOf(hash) >> 58); }

// Interval within which events count as one, since their order is not significant [s].
constexpr double kOneEvent = 2e-3;

// Events between `time` and `last_time` [s] as hashes, which are equal for equal events. `happened`
// combines limit impacts and touch-downs in any order. `state` combines the held hinges, the
// sticking and the sliding contacts, and the broken constraints afterwards. `is_unsure`: the error
// of a solution decides whether two of the events happened together or one after the other.
struct EventMark {
  double time = 0.0, last_time = 0.0;
  uint64_t happened = 0, state = 0;
  bool is_unsure = false;
};

// Events of a solution in order. Two solutions of one motion whose events differ, or could differ,
// are on different branches: their difference is no error estimate from there on. [METHOD 8.2]
class EventTrail {
 public:
  // Adds a mark, or merges it with the last one if both are within kOneEvent.
  void Add(const EventMark& mark) {
    if (marks_.empty() || mark.time - marks_.back().last_time > kOneEvent) {
      // Skip a mark that changes nothing.
      const uint64_t state = marks_.empty() ? 0 : marks_.back().state;
      const bool changes = mark.happened != 0 || mark.state != state;
      if (changes || mark.is_unsure) marks_.push_back(mark);
      return;
    }
    marks_.back().last_time = mark.last_time;
    marks_.back().happened |= mark.happened;
    marks_.back().state = mark.state;
    marks_.back().is_unsure |= mark.is_unsure;
  }

  // Returns the time from which two trails differ [s], as far as that is certain at t. Both trails
  // are known up to t, but one may not have reached an event of the other yet.
  static std::optional<double> Part(const EventTrail& a, const EventTrail& b, double t) {
    const size_t count = std::max(a.marks_.size(), b.marks_.size());
    for (size_t i = 0; i < count; ++i) {
      const EventMark& one = i < a.marks_.size() ? a.marks_[i] : b.marks_[i];
      const EventMark& other = i < b.marks_.size() ? b.marks_[i] : a.marks_[i];
      const bool are_both_there = &one != &other;
      const bool are_equal = one.happened == other.happened && one.state == other.state;
      if (are_both_there && are_equal && !one.is_unsure && !other.is_unsure) continue;
      const bool is_over = std::max(one.last_time, other.last_time) < t - 2.0 * kOneEvent;
      return is_over ? std::optional(std::min(one.time, other.time)) : std::nullopt;
    }
    return std::nullopt;
  }

 private:
  std::vector<EventMark> marks_;
};

}  // namespace hazumi
