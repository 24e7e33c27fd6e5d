#pragma once

// Internal. Stretches of frames, and sets of them that answer in the logarithm of their size.

#include <algorithm>
#include <map>

namespace hazumi {

// Half open, so that spans may touch.
struct Span {
  int first, last;
  bool is_empty() const { return first >= last; }
};

template <typename Item>
Span SpanOf(const Item& item) {
  return {item.first_frame, item.last_frame};
}

inline Span Common(Span a, Span b) {
  return {std::max(a.first, b.first), std::min(a.last, b.last)};
}

// The frames of all spans that were added.
class SpanSet {
 public:
  void Add(Span span) {
    Add(span, [](Span) {});
  }
  // `told` hears of each part of the span that was not in the set.
  template <typename Told>
  void Add(Span span, Told&& told);

  bool Overlaps(Span span) const {
    const auto it = FirstBeyond(span.first);
    return !span.is_empty() && it != spans_.end() && it->first < span.last;
  }
  // `told` hears of each part of the span that is in the set.
  template <typename Told>
  void ForEachCommon(Span span, Told&& told) const {
    for (auto it = FirstBeyond(span.first); it != spans_.end() && it->first < span.last; ++it) {
      told(Common(span, {it->first, it->second}));
    }
  }

 private:
  // The first span that ends beyond a frame.
  std::map<int, int>::const_iterator FirstBeyond(int frame) const {
    const auto next = spans_.upper_bound(frame);
    if (next == spans_.begin() || std::prev(next)->second <= frame) return next;
    return std::prev(next);
  }

  std::map<int, int> spans_;  // first to last; none overlap or touch
};

template <typename Told>
void SpanSet::Add(Span span, Told&& told) {
  if (span.is_empty()) return;
  auto next = spans_.upper_bound(span.first);
  if (next != spans_.begin() && std::prev(next)->second >= span.first) --next;
  Span whole = span;
  int from = span.first;
  while (next != spans_.end() && next->first <= span.last) {
    if (from < next->first) told(Span{from, next->first});
    from = std::max(from, next->second);
    whole = {std::min(whole.first, next->first), std::max(whole.last, next->second)};
    next = spans_.erase(next);
  }
  if (from < span.last) told(Span{from, span.last});
  spans_.emplace_hint(next, whole.first, whole.last);
}

}  // namespace hazumi
