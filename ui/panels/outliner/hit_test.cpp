#include "ui/panels/outliner/hit_test.h"

#include <cmath>

namespace hazumi::ui {

std::optional<OutlinerHit> HitOutliner(const std::vector<OutlinerRow>& rows,
                                       const OutlinerPlace& place, Point p) {
  if (!place.list.Contains(p)) return std::nullopt;
  const float below = std::floor((p.y - place.list.y + place.scroll) / place.row_height);
  const auto row = static_cast<size_t>(below);
  if (row >= rows.size()) return std::nullopt;
  const bool has_switches = IsSelectable(rows[row]);
  if (has_switches && place.Eye(row).Contains(p)) return OutlinerHit{row, OutlinerPart::kEye};
  if (has_switches && place.Lock(row).Contains(p)) return OutlinerHit{row, OutlinerPart::kLock};
  const bool opens = rows[row].has_rows && place.Disclosure(rows[row], row).Contains(p);
  return OutlinerHit{row, opens ? OutlinerPart::kDisclosure : OutlinerPart::kLabel};
}

}  // namespace hazumi::ui
