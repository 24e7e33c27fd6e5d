#pragma once

#include <optional>
#include <vector>

#include "ui/panels/outliner/layout.h"
#include "ui/panels/window/geometry.h"

namespace hazumi::ui {

// Where the rows are [px].
struct OutlinerPlace {
  Rect list;
  float row_height = 20.0f, indent = 12.0f;
  float scroll = 0.0f;  // of the list above its upper edge

  Rect RowRect(size_t row) const {
    return {list.x, list.y + static_cast<float>(row) * row_height - scroll, list.w, row_height};
  }
  // Whether it is hidden, and whether it is locked, at the end of the rows of joints and hinges.
  Rect Eye(size_t row) const { return Column(row, 2); }
  Rect Lock(size_t row) const { return Column(row, 1); }
  // The triangle that opens and closes a row.
  Rect Disclosure(const OutlinerRow& row, size_t index) const {
    const Rect rect = RowRect(index);
    return {rect.x + static_cast<float>(row.depth) * indent, rect.y, 1.4f * indent, rect.h};
  }

 private:
  Rect Column(size_t row, int from_right) const {
    const Rect rect = RowRect(row);
    const float width = 1.7f * indent;
    return {rect.right() - static_cast<float>(from_right) * width, rect.y, width, rect.h};
  }
};

enum class OutlinerPart { kLabel, kDisclosure, kEye, kLock };
struct OutlinerHit {
  size_t row;
  OutlinerPart part;
};
std::optional<OutlinerHit> HitOutliner(const std::vector<OutlinerRow>& rows,
                                       const OutlinerPlace& place, Point p);

}  // namespace hazumi::ui
