#pragma once

// Internal. Stretches of frames, and sets of them that answer in the logarithm of their size.

#include <algorithm>
#include <map>
#include <vector>

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

// The frames of all spans that were added. Most come in order of time: those cost next to nothing.
class SpanSet {
 public:
  void Add(Span span) {
    Add(span, [](Span) {});
  }
  // `told` hears of each part of the span that was not in the set; perhaps of some that was, but of
  // none more than twice.
  template <typename Told>
  void Add(Span span, Told&& told) {
    if (span.is_empty()) return;
    if (!in_order_.empty() && span.first < in_order_.back().first) return Insert(span, told);
    if (in_order_.empty() || span.first > in_order_.back().last) {
      in_order_.push_back(span);
      return told(span);
    }
    Span& before = in_order_.back();
    if (span.last > before.last) told(Span{before.last, span.last});
    before.last = std::max(before.last, span.last);
  }

  bool Overlaps(Span span) const {
    if (span.is_empty()) return false;
    const auto it = FirstBeyond(span.first);
    if (it != in_order_.end() && it->first < span.last) return true;
    const auto other = FirstOtherBeyond(span.first);
    return other != others_.end() && other->first < span.last;
  }
  // `told` hears of each part of the span that is in the set, of some perhaps twice.
  template <typename Told>
  void ForEachCommon(Span span, Told&& told) const {
    auto it = FirstBeyond(span.first);
    for (; it != in_order_.end() && it->first < span.last; ++it) told(Common(span, *it));
    auto other = FirstOtherBeyond(span.first);
    for (; other != others_.end() && other->first < span.last; ++other) {
      told(Common(span, {other->first, other->second}));
    }
  }

 private:
  using Others = std::map<int, int>;  // first to last

  // The first span that ends beyond a frame.
  std::vector<Span>::const_iterator FirstBeyond(int frame) const {
    return std::partition_point(in_order_.begin(), in_order_.end(),
                                [&](Span span) { return span.last <= frame; });
  }
  Others::const_iterator FirstOtherBeyond(int frame) const {
    const auto next = others_.upper_bound(frame);
    if (next == others_.begin() || std::prev(next)->second <= frame) return next;
    return std::prev(next);
  }

  template <typename Told>
  void Insert(Span span, Told&& told) {
    auto next = others_.upper_bound(span.first);
    if (next != others_.begin() && std::prev(next)->second >= span.first) --next;
    Span whole = span;
    int from = span.first;
    while (next != others_.end() && next->first <= span.last) {
      if (from < next->first) told(Span{from, next->first});
      from = std::max(from, next->second);
      whole = {std::min(whole.first, next->first), std::max(whole.last, next->second)};
      next = others_.erase(next);
    }
    if (from < span.last) told(Span{from, span.last});
    others_.emplace_hint(next, whole.first, whole.last);
  }

  // Each ascending; none of one overlap or touch.
  std::vector<Span> in_order_;
  Others others_;
};

}  // namespace hazumi
