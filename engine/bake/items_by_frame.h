#pragma once

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace hazumi {

// Which items of a list something happens to at a frame, found in the logarithm of their number.
class ItemsByFrame {
 public:
  using Entry = std::pair<int, int>;  // frame, index of the item

  void Add(int frame, size_t index) { entries_.emplace_back(frame, static_cast<int>(index)); }
  // After the last Add.
  void Sort() { std::sort(entries_.begin(), entries_.end()); }

  // In ascending order.
  std::span<const Entry> At(int frame) const {
    const auto is_before = [](const Entry& entry, int f) { return entry.first < f; };
    const auto is_after = [](int f, const Entry& entry) { return f < entry.first; };
    const auto first = std::lower_bound(entries_.begin(), entries_.end(), frame, is_before);
    return {first, std::upper_bound(first, entries_.end(), frame, is_after)};
  }

 private:
  std::vector<Entry> entries_;
};

}  // namespace hazumi
