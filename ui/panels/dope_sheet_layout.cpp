#include "ui/panels/dope_sheet_layout.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/project/joint_names.h"
#include "ui/edit/edits.h"

namespace hazumi::ui {

namespace {

constexpr double kRow = 20.0, kTallRow = 30.0;  // heights at scale 1 [px]

bool IsTall(const SheetRow& row) {
  return row.kind == RowKind::kLimb || row.kind == RowKind::kPlacement;
}

void PlaceRows(const SheetState& state, DopeSheetLayout* layout) {
  const SheetFrame& frame = layout->frame;
  float y = 0.0f;
  for (const SheetRow& row : layout->rows) {
    const auto h = static_cast<float>(std::round((IsTall(row) ? kTallRow : kRow) * frame.scale));
    layout->row_rects.push_back({frame.rect.x, y, frame.rect.w, h});
    y += h;
  }
  layout->content_height = y;
  const double most = std::max(0.0f, y - frame.tracks.h);
  const auto scroll = static_cast<float>(std::round(std::clamp(state.scroll_px, 0.0, most)));
  for (Rect& rect : layout->row_rects) rect.y += frame.tracks.y - scroll;
}

bool IsSeen(const DopeSheetLayout& layout, int row) {
  const Rect& rect = layout.row_rects[row];
  return rect.bottom() > layout.frame.tracks.y && rect.y < layout.frame.tracks.bottom();
}

// Keys of tall rows lie in their lower half, below the names of bars.
float KeyHeight(const DopeSheetLayout& layout, int row) {
  const Rect& rect = layout.row_rects[row];
  const double low = IsTall(layout.rows[row]) ? 8.5 * layout.frame.scale : 0.5 * rect.h;
  return std::round(rect.bottom() - static_cast<float>(low)) + 0.5f;
}

void PlaceKeys(const edit::Session& session, int row, DopeSheetLayout* layout) {
  const TimeAxis& axis = layout->frame.axis;
  const double reach = 8.0 * layout->frame.scale / axis.px_per_frame();
  std::map<double, RowKey> keys;
  for (const std::string& name : layout->rows[row].curves) {
    const ProjectCurve* curve = edit::FindCurve(name, session.project());
    if (!curve) continue;
    const auto before = [](const ProjectKey& key, double frame) { return key.frame < frame; };
    auto key = std::lower_bound(curve->keys.begin(), curve->keys.end(), axis.first - reach, before);
    for (; key != curve->keys.end() && key->frame <= axis.last + reach; ++key) {
      const bool is_selected = edit::Contains(session.selected_keys(), name, key->frame);
      const auto [entry, is_new] = keys.try_emplace(key->frame, RowKey{row, key->frame});
      RowKey& mark = entry->second;
      if (is_new) mark.interpolation = key->interpolation;
      if (mark.interpolation != key->interpolation) mark.interpolation.reset();
      mark.is_selected |= is_selected;
    }
  }
  const float y = KeyHeight(*layout, row);
  for (auto& [frame, key] : keys) {
    key.at = {axis.XOf(frame), y};
    layout->keys.push_back(key);
  }
}

RowBar BarOn(const DopeSheetLayout& layout, int row, bool is_region, int index, int first,
             int last) {
  const Rect& rect = layout.row_rects[row];
  const float left = layout.frame.axis.XOf(first), right = layout.frame.axis.XOf(last);
  return {row, is_region, index, {left, rect.y + 1.0f, right - left, rect.h - 2.0f}};
}

void PlaceRegions(const edit::Session& session, int row, DopeSheetLayout* layout) {
  const SheetRow& of = layout->rows[row];
  const std::vector<ProjectRegion>& regions = session.project().regions;
  for (size_t i = 0; i < regions.size(); ++i) {
    const std::vector<bool> held = JointsOf(regions[i], session.figure());
    RowBar bar = BarOn(*layout, row, true, static_cast<int>(i), regions[i].first_frame,
                       regions[i].last_frame);
    bar.num_hinges = static_cast<int>(of.hinges.size());
    for (const JointIndex j : of.hinges) bar.num_held += held[j.value()] ? 1 : 0;
    const bool turns_root =
        of.kind == RowKind::kPlacement && DrivesRoot(regions[i], session.figure());
    if (of.kind == RowKind::kSummary || (bar.num_held == 0 && !turns_root)) continue;
    layout->bars.push_back(bar);
  }
}

// Regions of one limb that overlap in time share the height of the row.
void ShareHeight(size_t begin, std::vector<RowBar>* bars) {
  std::vector<float> ends;  // of lanes
  std::vector<size_t> lanes;
  for (size_t i = begin; i < bars->size(); ++i) {
    const Rect& rect = (*bars)[i].rect;
    size_t lane = 0;
    while (lane < ends.size() && ends[lane] > rect.x + 0.5f) ++lane;
    if (lane == ends.size()) ends.push_back(0.0f);
    ends[lane] = rect.right();
    lanes.push_back(lane);
  }
  for (size_t i = begin; i < bars->size() && ends.size() > 1; ++i) {
    Rect& rect = (*bars)[i].rect;
    rect.h /= static_cast<float>(ends.size());
    rect.y += rect.h * static_cast<float>(lanes[i - begin]);
  }
}

void PlaceBars(const edit::Session& session, int row, DopeSheetLayout* layout) {
  const size_t begin = layout->bars.size();
  if (layout->rows[row].kind == RowKind::kPlacement) {
    const std::vector<ProjectPlacement>& spans = session.project().placements;
    for (size_t i = 0; i < spans.size(); ++i) {
      layout->bars.push_back(BarOn(*layout, row, false, static_cast<int>(i), spans[i].first_frame,
                                   spans[i].last_frame));
    }
  }
  PlaceRegions(session, row, layout);
  std::sort(layout->bars.begin() + static_cast<long>(begin), layout->bars.end(),
            [](const RowBar& a, const RowBar& b) { return a.rect.x < b.rect.x; });
  ShareHeight(begin, &layout->bars);
}

bool Touches(Point mark, Point p, double scale) {
  const auto reach = static_cast<float>(6.0 * scale);
  return std::abs(mark.x - p.x) + std::abs(mark.y - p.y) <= 1.4f * reach;
}

SheetHit HitTracks(const DopeSheetLayout& layout, int row, Point p) {
  const double scale = layout.frame.scale;
  for (size_t i = layout.keys.size(); i-- > 0;) {
    if (layout.keys[i].row == row && Touches(layout.keys[i].at, p, scale)) {
      return {SheetPart::kKey, static_cast<int>(i), row};
    }
  }
  const auto edge = static_cast<float>(5.0 * scale);
  SheetHit inside = {SheetPart::kTrack, -1, row};
  for (size_t i = 0; i < layout.bars.size(); ++i) {
    const RowBar& bar = layout.bars[i];
    if (bar.row != row || p.y < bar.rect.y || p.y >= bar.rect.bottom()) continue;
    // Of a short bar the middle stays for moving it; outside its ends there is room for them.
    const float within = std::min(edge, bar.rect.w / 4.0f);
    const float from_left = p.x - bar.rect.x, from_right = p.x - bar.rect.right();
    const int index = static_cast<int>(i);
    if (from_right >= -within && from_right <= edge) return {SheetPart::kBarEnd, index, row};
    if (from_left >= -edge && from_left <= within) {
      inside = {SheetPart::kBarStart, index, row};
    } else if (from_left > 0.0f && from_right < 0.0f) {
      inside = {SheetPart::kBar, index, row};
    }
  }
  return inside;
}

}  // namespace

DopeSheetLayout LayOutDopeSheet(const edit::Session& session, const SheetState& state,
                                const Rect& rect, double scale) {
  DopeSheetLayout layout;
  layout.frame = LayOutSheetFrame(session, state, rect, scale);
  layout.rows = SheetRows(session, state);
  PlaceRows(state, &layout);
  for (int row = 0; row < static_cast<int>(layout.rows.size()); ++row) {
    if (!IsSeen(layout, row)) continue;
    PlaceKeys(session, row, &layout);
    PlaceBars(session, row, &layout);
  }
  return layout;
}

SheetHit HitDopeSheet(const DopeSheetLayout& layout, const edit::Session& session, Point p) {
  const SheetFrame& frame = layout.frame;
  if (frame.corner.Contains(p)) return {SheetPart::kCorner};
  if (frame.ruler.Contains(p)) return {SheetPart::kRuler};
  const int marker = MarkerAt(session, frame, p);
  if (marker >= 0) return {SheetPart::kMarker, marker};
  if (!frame.names.Contains(p) && !frame.tracks.Contains(p)) return {};
  for (int row = 0; row < static_cast<int>(layout.rows.size()); ++row) {
    const Rect& rect = layout.row_rects[row];
    if (p.y < rect.y || p.y >= rect.bottom()) continue;
    if (frame.tracks.Contains(p)) return HitTracks(layout, row, p);
    const double arrow_end = (16.0 + 12.0 * layout.rows[row].depth) * frame.scale;
    const bool is_arrow = layout.rows[row].has_parts && p.x - frame.names.x < arrow_end;
    return {is_arrow ? SheetPart::kArrow : SheetPart::kName, -1, row};
  }
  return {};
}

int NearestRow(const DopeSheetLayout& layout, float y) {
  for (size_t i = 0; i < layout.rows.size(); ++i) {
    if (y < layout.row_rects[i].bottom()) return static_cast<int>(i);
  }
  return static_cast<int>(layout.rows.size()) - 1;
}

KeyList KeysOf(const DopeSheetLayout& layout, const RowKey& key, const Project& project) {
  KeyList keys;
  for (const std::string& name : layout.rows[key.row].curves) {
    const ProjectCurve* curve = edit::FindCurve(name, project);
    if (!curve || !edit::KeyOn(key.frame, *curve)) continue;
    keys.curves.push_back(name);
    keys.frames.push_back(key.frame);
  }
  return keys;
}

KeyList KeysIn(const DopeSheetLayout& layout, const Rect& box, const Project& project) {
  KeyList all;
  for (const RowKey& key : layout.keys) {
    if (!box.Contains(key.at)) continue;
    const KeyList keys = KeysOf(layout, key, project);
    all.curves.insert(all.curves.end(), keys.curves.begin(), keys.curves.end());
    all.frames.insert(all.frames.end(), keys.frames.begin(), keys.frames.end());
  }
  return all;
}

}  // namespace hazumi::ui
