#include "ui/panels/dope_sheet/layout.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/project/checks/joint_names.h"
#include "ui/edit/operators/edits.h"
#include "ui/panels/dope_sheet/bars.h"

namespace hazumi::ui {

namespace {

// At scale 1 [px].
constexpr double kRow = 20.0, kTallRow = 30.0;   // heights, at least
constexpr double kLane = 9.0, kTallLane = 16.0;  // of several bars, one below the other
constexpr double kHold = 6.0, kTallHold = 15.0;  // bars of holds, at most

bool IsTall(const SheetRow& row) {
  return row.kind == RowKind::kLimb || row.kind == RowKind::kPlacement ||
         row.kind == RowKind::kRoot || row.kind == RowKind::kObject;
}

float Px(const DopeSheetLayout& layout, double at_scale_1) {
  return static_cast<float>(std::round(at_scale_1 * layout.frame.scale));
}

// The bars of a row, without their places.
class BarList {
 public:
  explicit BarList(const edit::Session& session)
      : figure_(session.figure()), project_(session.project()) {
    for (const ProjectRegion& region : project_.regions) {
      held_.push_back(JointsOf(region, figure_));
      drives_.push_back(DrivesByJoint(region, figure_));
    }
    for (const ProjectFill& fill : project_.fills)
      filled_.push_back(JointsOf(fill.joints, figure_));
    for (const BarType* type : AllBarTypes()) {
      for (int i = 0; i < type->Num(project_); ++i) {
        entries_.push_back({{type->kind, i}, type->Rows(project_, i)});
      }
    }
  }

  std::vector<RowBar> On(const SheetRow& row) const {
    std::vector<RowBar> bars;
    if (row.kind == RowKind::kSummary) return bars;
    for (const Entry& entry : entries_) {
      if (entry.bar.kind == BarKind::kRegion) {
        AddRegion(row, entry.bar.index, &bars);
      } else if (entry.bar.kind == BarKind::kFill) {
        if (IsFilled(row, static_cast<size_t>(entry.bar.index))) bars.push_back({0, entry.bar});
      } else if (IsOn(entry.rows, row)) {
        bars.push_back({0, entry.bar});
      }
    }
    return bars;
  }

 private:
  template <typename T>
  static int NumOf(const std::vector<T>& list) {
    return static_cast<int>(list.size());
  }

  void AddRegion(const SheetRow& row, int index, std::vector<RowBar>* bars) const {
    RowBar bar = {0, {BarKind::kRegion, index}};
    bar.num_hinges = NumOf(row.hinges);
    std::vector<JointIndex> held = row.hinges;
    std::erase_if(held, [&](JointIndex j) { return !held_[index][j.value()]; });
    bar.num_held = NumOf(held);
    const ProjectRegion& region = project_.regions[index];
    if (!region.mute) bar.muscle = MuscleOf(region, drives_[index], held);
    bar.touches = region.contacts.is_any() && !region.mute;
    const bool turns_root = row.kind == RowKind::kRoot && DrivesRoot(region, figure_);
    if (bar.num_held > 0 || turns_root) bars->push_back(bar);
  }

  bool IsFilled(const SheetRow& row, size_t fill) const {
    if (row.kind == RowKind::kRoot) return NameRoot(project_.fills[fill].joints, figure_);
    return std::any_of(row.hinges.begin(), row.hinges.end(),
                       [&](JointIndex j) { return filled_[fill][static_cast<size_t>(j.value())]; });
  }

  // A joint is held as a whole: its hinges' rows show nothing of it.
  bool IsOn(const std::string& held, const SheetRow& row) const {
    if (row.kind != RowKind::kLimb && row.kind != RowKind::kJoint) return false;
    const std::optional<MeantJoints> meant = FindJoints(figure_, held);
    return std::any_of(row.hinges.begin(), row.hinges.end(), [&](JointIndex j) {
      return meant && figure_.joint(j).group == meant->group;
    });
  }

  bool IsOn(const BarRows& rows, const SheetRow& row) const {
    if (row.kind == RowKind::kPlacement) return rows.of_placement;
    if (row.object.is_valid()) {
      const int held = IndexOf(row.object, project_.held_objects);
      return held >= 0 && std::count(rows.objects.begin(), rows.objects.end(),
                                     project_.held_objects[held].name) > 0;
    }
    return std::any_of(rows.joints.begin(), rows.joints.end(), [&](const std::string& joint) {
      return row.kind == RowKind::kRoot ? MeansRoot(joint, figure_) : IsOn(joint, row);
    });
  }

  const Figure& figure_;
  const Project& project_;
  std::vector<std::vector<bool>> held_;    // by region and joint
  std::vector<std::vector<int>> drives_;   // likewise, -1 where it is limp
  std::vector<std::vector<bool>> filled_;  // by fill and joint
  struct Entry {
    BarRef bar;
    BarRows rows;
  };
  std::vector<Entry> entries_;  // in the order in which they lie on a row
};

// Puts bars that overlap in time into lanes of their own. Returns how many lanes there are.
int TakeLanes(const Project& project, std::vector<RowBar>* bars) {
  const auto first = [&](const RowBar& bar) { return FramesOf(project, bar.ref).first; };
  std::stable_sort(bars->begin(), bars->end(),
                   [&](const RowBar& a, const RowBar& b) { return first(a) < first(b); });
  std::vector<int> ends;  // of lanes
  for (RowBar& bar : *bars) {
    const ProjectFrames frames = FramesOf(project, bar.ref);
    const auto is_free = [&](int end) { return end <= frames.first; };
    const auto lane = std::find_if(ends.begin(), ends.end(), is_free);
    bar.lane = static_cast<int>(lane - ends.begin());
    if (lane == ends.end()) ends.push_back(0);
    ends[bar.lane] = frames.last;
  }
  return static_cast<int>(ends.size());
}

// A bar alone fills its row; several share it, and in tall rows leave the keys' half free.
Rect PlaceOf(const RowBar& bar, const Project& project, int num_lanes,
             const DopeSheetLayout& layout) {
  const bool is_tall = IsTall(layout.rows[bar.row]);
  const Rect& row = layout.row_rects[bar.row];
  const ProjectFrames frames = FramesOf(project, bar.ref);
  const float left = layout.frame.axis.XOf(frames.first);
  Rect rect = {left, row.y + 1.0f, layout.frame.axis.XOf(frames.last) - left, row.h - 2.0f};
  if (num_lanes > 1) {
    const float lane = Px(layout, is_tall ? kTallLane : kLane);
    rect.y += lane * static_cast<float>(bar.lane);
    rect.h = lane - 1.0f;
  }
  if (TypeOf(bar.ref.kind).is_thin) {
    rect.h = std::min(rect.h, Px(layout, is_tall ? kTallHold : kHold));
  }
  return rect;
}

float HeightOf(const SheetRow& row, int num_lanes, const DopeSheetLayout& layout) {
  const float least = Px(layout, IsTall(row) ? kTallRow : kRow);
  if (num_lanes < 2) return least;
  const double keys = IsTall(row) ? kTallRow - kTallLane : 0.0;
  const double lanes = num_lanes * (IsTall(row) ? kTallLane : kLane);
  return std::max(least, Px(layout, lanes + keys) + 1.0f);
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
    const ProjectCurve* curve = FindCurve(name, session.project());
    if (!curve) continue;
    const auto before = [](const ProjectKey& key, double frame) { return key.frame < frame; };
    auto key = std::lower_bound(curve->keys.begin(), curve->keys.end(), axis.first - reach, before);
    for (; key != curve->keys.end() && key->frame <= axis.last + reach; ++key) {
      const bool is_selected = Contains(session.selected_keys(), name, key->frame);
      const auto [entry, is_new] = keys.try_emplace(key->frame, RowKey{row, key->frame});
      RowKey& mark = entry->second;
      if (is_new) mark.interpolation = key->interpolation;
      if (mark.interpolation != key->interpolation) mark.interpolation.reset();
      if (is_new) mark.type = key->type;
      if (mark.type != key->type) mark.type = KeyType::kKeyframe;
      mark.is_selected |= is_selected;
    }
  }
  const float y = KeyHeight(*layout, row);
  for (auto& [frame, key] : keys) {
    key.at = {axis.XOf(frame), y};
    layout->keys.push_back(key);
  }
}

// Rows one below the other, as high as their bars ask for; scrolled. Returns their lanes.
std::vector<int> PlaceRows(const edit::Session& session, const SheetState& state,
                           DopeSheetLayout* layout) {
  const BarList list(session);
  std::vector<int> num_lanes;
  float y = 0.0f;
  for (int row = 0; row < static_cast<int>(layout->rows.size()); ++row) {
    std::vector<RowBar> bars = list.On(layout->rows[row]);
    for (RowBar& bar : bars) bar.row = row;
    num_lanes.push_back(TakeLanes(session.project(), &bars));
    layout->bars.insert(layout->bars.end(), bars.begin(), bars.end());
    const float h = HeightOf(layout->rows[row], num_lanes.back(), *layout);
    layout->row_rects.push_back({layout->frame.rect.x, y, layout->frame.rect.w, h});
    y += h;
  }
  layout->content_height = y;
  const double most = std::max(0.0f, y - layout->frame.tracks.h);
  const auto scroll = static_cast<float>(std::round(std::clamp(state.scroll_px, 0.0, most)));
  for (Rect& rect : layout->row_rects) rect.y += layout->frame.tracks.y - scroll;
  return num_lanes;
}

bool Touches(Point mark, Point p, double scale) {
  const auto reach = static_cast<float>(6.0 * scale);
  return std::abs(mark.x - p.x) + std::abs(mark.y - p.y) <= 1.4f * reach;
}

// Of a short bar the middle stays for moving it. Beside its ends there is room for them, unless
// another bar is there.
SheetHit HitBars(const DopeSheetLayout& layout, int row, Point p) {
  const auto edge = static_cast<float>(5.0 * layout.frame.scale);
  const auto near = static_cast<float>(3.0 * layout.frame.scale);
  SheetHit beside = {SheetPart::kTrack, -1, row};
  for (size_t i = 0; i < layout.bars.size(); ++i) {
    const RowBar& bar = layout.bars[i];
    if (bar.row != row || p.y < bar.rect.y || p.y >= bar.rect.bottom()) continue;
    const float within = std::min(edge, bar.rect.w / 4.0f);
    const float from_left = p.x - bar.rect.x, from_right = p.x - bar.rect.right();
    const int index = static_cast<int>(i);
    if (from_left >= 0.0f && from_right < 0.0f) {
      const bool is_on_strip = bar.muscle.spring >= 0 && std::abs(p.y - StripOf(bar).y) < near;
      const SheetPart part = from_right >= -within ? SheetPart::kBarEnd
                             : from_left <= within ? SheetPart::kBarStart
                             : is_on_strip         ? SheetPart::kBarStrength
                                                   : SheetPart::kBar;
      return {part, index, row};
    }
    if (from_right >= 0.0f && from_right <= edge) beside = {SheetPart::kBarEnd, index, row};
    if (from_left < 0.0f && from_left >= -edge) beside = {SheetPart::kBarStart, index, row};
  }
  return beside;
}

SheetHit HitTracks(const DopeSheetLayout& layout, int row, Point p) {
  const double scale = layout.frame.scale;
  for (size_t i = layout.keys.size(); i-- > 0;) {
    if (layout.keys[i].row == row && Touches(layout.keys[i].at, p, scale)) {
      return {SheetPart::kKey, static_cast<int>(i), row};
    }
  }
  return HitBars(layout, row, p);
}

}  // namespace

Rect StripOf(const RowBar& bar) {
  const auto height = static_cast<float>(bar.muscle.fill()) * bar.rect.h;
  return {bar.rect.x, bar.rect.bottom() - height, bar.rect.w, height};
}

DopeSheetLayout LayOutDopeSheet(const edit::Session& session, const SheetState& state,
                                const Rect& rect, double scale) {
  DopeSheetLayout layout;
  layout.frame = LayOutSheetFrame(session, state, rect, scale);
  layout.rows = SheetRows(session, state);
  const std::vector<int> num_lanes = PlaceRows(session, state, &layout);
  std::erase_if(layout.bars, [&](const RowBar& bar) { return !IsSeen(layout, bar.row); });
  for (RowBar& bar : layout.bars) {
    bar.rect = PlaceOf(bar, session.project(), num_lanes[bar.row], layout);
  }
  for (int row = 0; row < static_cast<int>(layout.rows.size()); ++row) {
    if (IsSeen(layout, row)) PlaceKeys(session, row, &layout);
  }
  return layout;
}

SheetHit HitDopeSheet(const DopeSheetLayout& layout, const edit::Session& session, Point p) {
  const SheetFrame& frame = layout.frame;
  if (frame.corner.Contains(p)) return {SheetPart::kCorner};
  if (frame.ruler.Contains(p)) return {SheetPart::kRuler};
  const int marker = MarkerAt(session, frame, p);
  if (marker >= 0) return {SheetPart::kMarker, marker};
  if (frame.markers.Contains(p) || frame.sound.Contains(p)) return {SheetPart::kRuler};
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
    const ProjectCurve* curve = FindCurve(name, project);
    if (!curve || !KeyOn(key.frame, *curve)) continue;
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
