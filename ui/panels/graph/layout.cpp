#include "ui/panels/graph/layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/project/fields/curve_fields.h"
#include "ui/edit/operators/edits.h"
#include "ui/panels/graph/curves.h"

namespace hazumi::ui {

namespace {

constexpr double kNameHeight = 20.0, kHandlePx = 34.0, kToggle = 24.0;  // at scale 1

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void Include(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool is_empty() const { return low > high; }
};

Extent ExtentOf(const GraphLayout& layout, int curve) {
  Extent extent;
  for (const auto& [frame, value] : layout.curves[curve].points) extent.Include(value);
  for (const GraphKey& key : layout.keys) {
    if (key.curve == curve) extent.Include(key.value);
  }
  return extent;
}

void AddKeys(const edit::Session& session, const Motion* motion, int index, GraphLayout* layout) {
  const GraphCurve& curve = layout->curves[index];
  const ProjectCurve* keyed = FindCurve(curve.name, session.project());
  if (!keyed) return;
  for (const ProjectKey& from : keyed->keys) {
    GraphKey key{index, from.frame, from.value};
    key.interpolation = from.interpolation;
    key.is_selected = Contains(session.selected_keys(), curve.name, from.frame);
    if (motion) RatesAt(*motion, curve, &key);
    if (from.rate) key.rate_before = key.rate = *from.rate;
    if (from.rate_in) key.rate_before = *from.rate_in;
    key.type = from.type;
    key.is_broken = from.rate_in.has_value();
    key.lengths = {from.length_in, from.length_out};
    const ProjectKey* const first = keyed->keys.data();
    if (&from != first) key.frames_beside[0] = from.frame - (&from)[-1].frame;
    if (&from != &keyed->keys.back()) key.frames_beside[1] = (&from)[1].frame - from.frame;
    layout->keys.push_back(key);
  }
}

void Normalize(GraphLayout* layout) {
  for (size_t i = 0; i < layout->curves.size(); ++i) {
    const Extent extent = ExtentOf(*layout, static_cast<int>(i));
    if (extent.is_empty()) continue;
    GraphCurve& curve = layout->curves[i];
    curve.middle = 0.5 * (extent.low + extent.high);
    curve.stretch = extent.high - extent.low > 1e-9 ? 2.0 / (extent.high - extent.low) : 1.0;
  }
}

// All that is shown, with room above and below.
ValueRange Fitted(const GraphLayout& layout) {
  Extent all;
  for (size_t i = 0; i < layout.curves.size(); ++i) {
    const GraphCurve& curve = layout.curves[i];
    const Extent extent = ExtentOf(layout, static_cast<int>(i));
    if (extent.is_empty() || curve.is_hidden) continue;
    all.Include((extent.low - curve.middle) * curve.stretch);
    all.Include((extent.high - curve.middle) * curve.stretch);
  }
  if (all.is_empty()) return {};
  const double least = 1e-3;
  const double room = std::max(0.1 * (all.high - all.low), least);
  return {all.low - room, all.high + room};
}

// Handles point along the curve. They are equally long on the screen, or as long as is said.
void PlaceHandles(const GraphLayout& layout, GraphKey* key) {
  const bool counts = key->interpolation == Interpolation::kCubic ||
                      key->interpolation == Interpolation::kQuadratic;
  if (!key->is_selected || !counts) return;
  const GraphCurve& curve = layout.curves[key->curve];
  const auto end = [&](double rate, int side_index) {
    const double side = side_index == 0 ? -1.0 : 1.0;
    const double reach =
        key->lengths[side_index].value_or(0.0) * key->frames_beside[side_index] * side;
    if (reach != 0.0) {
      return layout.At(curve, key->frame + reach,
                       key->value + reach * rate / layout.frames_per_second);
    }
    const Point next =
        layout.At(curve, key->frame + 1.0, key->value + rate / layout.frames_per_second);
    const double dx = next.x - key->at.x, dy = next.y - key->at.y;
    const double by = side * kHandlePx * layout.frame.scale / std::hypot(dx, dy);
    return Point{key->at.x + static_cast<float>(by * dx), key->at.y + static_cast<float>(by * dy)};
  };
  key->handles = {end(key->rate_before, 0), end(key->rate, 1)};
}

bool IsNear(Point a, Point b, double reach) { return std::hypot(a.x - b.x, a.y - b.y) <= reach; }

}  // namespace

float GraphLayout::YOf(double shown) const {
  const double part = (shown - values.low) / (values.high - values.low);
  return frame.tracks.bottom() - static_cast<float>(part * frame.tracks.h);
}

double GraphLayout::ShownAt(float y) const {
  const double part = (frame.tracks.bottom() - y) / std::max(1.0f, frame.tracks.h);
  return values.low + part * (values.high - values.low);
}

Point GraphLayout::At(const GraphCurve& curve, double at_frame, double value) const {
  return {frame.axis.XOf(at_frame), YOf((value - curve.middle) * curve.stretch)};
}

Rect GraphLayout::NameRect(int curve) const {
  const auto h = static_cast<float>(kNameHeight * frame.scale);
  return {frame.names.x, frame.names.y + h * static_cast<float>(curve), frame.names.w, h};
}

GraphLayout LayOutGraph(const edit::Session& session, const Motion* motion, const SheetState& state,
                        bool fits, const Rect& rect, double scale) {
  GraphLayout layout;
  layout.frame = LayOutSheetFrame(session, state, rect, scale);
  Rect& tracks = layout.frame.tracks;
  if (state.torque) tracks.h = std::round((1.0f - static_cast<float>(kTorqueShare)) * tracks.h);
  const auto toggle = static_cast<float>(kToggle * scale);
  const Rect& names = layout.frame.names;
  layout.torque_toggle = {names.x, state.torque ? tracks.bottom() : tracks.bottom() - toggle,
                          names.w, toggle};
  const ProjectRate& fps = session.project().fps;
  layout.frames_per_second = static_cast<double>(fps.num) / fps.den;
  for (const std::string& name : ShownCurves(session, state)) {
    const int index = static_cast<int>(layout.curves.size());
    layout.curves.push_back(CurveFor(session, name));
    layout.curves.back().color = index;
    layout.curves.back().is_hidden = state.hidden.contains(name);
    if (motion) SampleCurve(session, *motion, layout.frame.axis, &layout.curves.back());
    AddKeys(session, motion, index, &layout);
  }
  if (state.normalize) Normalize(&layout);
  layout.values = fits ? Fitted(layout) : state.values;
  for (GraphKey& key : layout.keys) {
    key.at = layout.At(layout.curves[key.curve], key.frame, key.value);
    PlaceHandles(layout, &key);
  }
  return layout;
}

GraphLayout CurrentGraph(Editor* editor, bool fits) {
  const Result<const Motion*> found = editor->session().ShownMotionTo(editor->last_frame());
  const Motion* motion = found.ok() ? found.value() : nullptr;
  const Rect& rect = editor->sheet.rect;
  GraphLayout layout =
      LayOutGraph(editor->session(), motion, editor->sheet, fits, rect, editor->settings.scale);
  if (!editor->sheet.torque) return layout;
  const Rect& tracks = layout.frame.tracks;
  const Rect below = {tracks.x, tracks.bottom(), tracks.w, rect.bottom() - tracks.bottom()};
  layout.torque = LayOutTorque(&editor->session(), motion, editor->effort, layout,
                               editor->viewport.active_hinge, below);
  return layout;
}

GraphHit HitGraph(const GraphLayout& layout, Point p) {
  const SheetFrame& frame = layout.frame;
  if (frame.corner.Contains(p)) return {GraphPart::kCorner};
  if (layout.torque_toggle.Contains(p)) return {GraphPart::kTorqueToggle};
  if (layout.torque && layout.torque->rect.Contains(p)) return {GraphPart::kTorque};
  if (frame.ruler.Contains(p) || frame.markers.Contains(p) || frame.sound.Contains(p)) {
    return {GraphPart::kRuler};
  }
  for (size_t i = 0; i < layout.curves.size(); ++i) {
    const int index = static_cast<int>(i);
    if (frame.names.Contains(p) && layout.NameRect(index).Contains(p)) {
      return {GraphPart::kName, index};
    }
  }
  if (!frame.tracks.Contains(p)) return {};
  const double reach = 6.0 * frame.scale;
  GraphHit hit = {GraphPart::kTrack};
  for (size_t i = 0; i < layout.keys.size(); ++i) {
    const GraphKey& key = layout.keys[i];
    if (layout.curves[key.curve].is_hidden) continue;
    if (IsNear(key.at, p, reach)) return {GraphPart::kKey, static_cast<int>(i)};
    for (int side = 0; side < 2 && key.handles; ++side) {
      if (IsNear((*key.handles)[side], p, reach)) {
        hit = {GraphPart::kHandle, static_cast<int>(i), side};
      }
    }
  }
  return hit;
}

double RateTowards(const GraphLayout& layout, const GraphKey& key, int side, Point p) {
  const GraphCurve& curve = layout.curves[key.curve];
  const double sign = side == 0 ? -1.0 : 1.0;
  // Never across the key: as steep as can be at the most.
  const double along = std::max(1.0, sign * (p.x - key.at.x)) / layout.frame.axis.px_per_frame();
  const double value = layout.ShownAt(p.y) / curve.stretch + curve.middle;
  return sign * (value - key.value) / along * layout.frames_per_second;
}

std::optional<double> LengthTowards(const GraphLayout& layout, const GraphKey& key, int side,
                                    Point p) {
  if (!key.lengths[side] || key.frames_beside[side] <= 0.0) return std::nullopt;
  const double frames = std::abs(p.x - key.at.x) / layout.frame.axis.px_per_frame();
  return std::clamp(frames / key.frames_beside[side], kTangentLength.lower, kTangentLength.upper);
}

KeyList GraphKeysIn(const GraphLayout& layout, const Rect& box) {
  KeyList keys;
  for (const GraphKey& key : layout.keys) {
    if (!box.Contains(key.at) || layout.curves[key.curve].is_hidden) continue;
    keys.curves.push_back(layout.curves[key.curve].name);
    keys.frames.push_back(key.frame);
  }
  return keys;
}

double ValuePerPx(Editor* editor) {
  const GraphLayout layout = CurrentGraph(editor);
  double stretch = 1.0;
  for (const GraphKey& key : layout.keys) {
    if (key.is_selected) stretch = layout.curves[key.curve].stretch;
  }
  return (layout.values.high - layout.values.low) / std::max(1.0f, layout.frame.tracks.h) / stretch;
}

void FrameValues(Editor* editor, const KeySelection& keys) {
  const GraphLayout layout = CurrentGraph(editor);
  Extent extent;
  for (const GraphKey& key : layout.keys) {
    const GraphCurve& curve = layout.curves[key.curve];
    if (!Contains(keys, curve.name, key.frame)) continue;
    extent.Include((key.value - curve.middle) * curve.stretch);
  }
  if (extent.is_empty()) return;
  const double room = std::max(0.15 * (extent.high - extent.low), 0.5);
  editor->sheet.values = {extent.low - room, extent.high + room};
  editor->sheet.fits_values = false;
}

}  // namespace hazumi::ui
