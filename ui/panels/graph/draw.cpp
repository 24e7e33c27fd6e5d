#include <cmath>

#include "engine/base/text.h"
#include "ui/panels/graph/input.h"
#include "ui/panels/graph/torque_draw.h"
#include "ui/panels/sheet/drawing.h"
#include "ui/panels/sheet/popups.h"
#include "ui/panels/window/panels.h"

namespace hazumi::ui {

namespace {

class GraphPainter {
 public:
  GraphPainter(ImDrawList* list, Editor* editor, const GraphLayout& layout)
      : list_(list), editor_(editor), theme_(editor->theme()), layout_(layout) {}

  void Draw() {
    const SheetFrame& frame = layout_.frame;
    list_->AddRectFilled(UpperLeft(frame.tracks), LowerRight(frame.tracks), ToIm(theme_.row));
    DrawValueGrid();
    DrawTimeGrid(list_, *editor_, frame);
    list_->PushClipRect(UpperLeft(frame.tracks), LowerRight(frame.tracks), true);
    for (const GraphCurve& curve : layout_.curves) DrawCurve(curve);
    for (const GraphKey& key : layout_.keys) DrawHandles(key);
    for (const GraphKey& key : layout_.keys) {
      if (layout_.curves[key.curve].is_hidden) continue;
      DrawKey(list_, key.at, Px(3.8), {key.interpolation, key.type, key.is_selected});
    }
    DrawValues();
    if (layout_.curves.empty()) DrawNothing();
    list_->PopClipRect();
    if (layout_.torque) DrawTorque(list_, *editor_, layout_);
    DrawNames();
    DrawRuler(list_, editor_, frame);
    DrawCornerToggle(list_, *editor_, layout_.torque_toggle, Tr("Torque"), editor_->sheet.torque);
    DrawCornerToggle(list_, *editor_, frame.corner, Tr("Normalize"), editor_->sheet.normalize);
    if (const auto& box = editor_->sheet.box) {
      list_->AddRectFilled(UpperLeft(*box), LowerRight(*box), IM_COL32(255, 255, 255, 24));
      list_->AddRect(UpperLeft(*box), LowerRight(*box), IM_COL32(255, 255, 255, 150));
    }
  }

 private:
  float Px(double at_scale_1) const { return static_cast<float>(at_scale_1 * layout_.frame.scale); }

  std::vector<Tick> Lines() const {
    return ValueTicks(layout_.values.low, layout_.values.high, layout_.frame.tracks.h, Px(28.0));
  }

  void DrawValueGrid() {
    const Rect& tracks = layout_.frame.tracks;
    for (const Tick& tick : Lines()) {
      const float y = std::round(layout_.YOf(tick.value)) + 0.5f;
      const bool is_zero = std::abs(tick.value) < 1e-9;
      list_->AddLine({tracks.x, y}, {tracks.right(), y}, ToIm(theme_.line, is_zero ? 1.0f : 0.4f));
    }
  }

  // Degrees, metres where all are positions, none where they are normalized.
  const char* Unit() const {
    if (editor_->sheet.normalize) return "";
    bool has_angles = layout_.curves.empty(), has_metres = false;
    for (const GraphCurve& curve : layout_.curves) {
      const bool is_angle = curve.hinge || (!curve.object && curve.root_curve >= kRootAngleZ);
      (is_angle ? has_angles : has_metres) = true;
    }
    return has_angles && has_metres ? "" : has_angles ? "°" : " m";
  }

  void DrawValues() {
    const Rect& tracks = layout_.frame.tracks;
    for (const Tick& tick : Lines()) {
      const double value = std::abs(tick.value) < 1e-9 ? 0.0 : tick.value;
      const std::string text = FormatShort(value) + Unit();
      const float y = layout_.YOf(tick.value) - ImGui::GetFontSize();
      list_->AddText({tracks.x + Px(4.0), std::round(y)}, ToIm(theme_.faint_text), text.c_str());
    }
  }

  void DrawNothing() {
    const Rect& tracks = layout_.frame.tracks;
    const char* text =
        Tr("Select joints, in the viewport or by their names in the dope sheet, to "
           "see their curves");
    const ImVec2 size = ImGui::CalcTextSize(text);
    list_->AddText({tracks.x + 0.5f * (tracks.w - size.x), tracks.y + 0.45f * tracks.h},
                   ToIm(theme_.faint_text), text);
  }

  // Solid, and dashed where a region computed it.
  void DrawCurve(const GraphCurve& curve) {
    if (curve.is_hidden) return;
    const ImU32 color = ToIm(CurveColor(curve.color));
    const TimeAxis& axis = layout_.frame.axis;
    double along = 0.0;  // of the dashes [px]
    for (size_t i = 0; i < curve.is_computed.size(); ++i) {
      const auto& [f0, v0] = curve.points[i];
      const auto& [f1, v1] = curve.points[i + 1];
      if (f1 < axis.first || f0 > axis.last) continue;
      const Point a = layout_.At(curve, f0, v0), b = layout_.At(curve, f1, v1);
      if (curve.is_computed[i]) {
        DrawDashes(a, b, color, &along);
      } else {
        list_->AddLine(ToIm(a), ToIm(b), color, Px(1.6));
      }
    }
  }

  void DrawDashes(Point a, Point b, ImU32 color, double* along) {
    const double length = std::hypot(b.x - a.x, b.y - a.y), on = Px(5.0), period = Px(9.0);
    for (double s = 0.0; s < length;) {
      const double phase = std::fmod(*along, period);
      const bool is_on = phase < on;
      const double step = std::min(length - s, (is_on ? on : period) - phase + 1e-3);
      if (is_on) {
        const auto p = static_cast<float>(s / length);
        const auto q = static_cast<float>((s + step) / length);
        list_->AddLine({a.x + p * (b.x - a.x), a.y + p * (b.y - a.y)},
                       {a.x + q * (b.x - a.x), a.y + q * (b.y - a.y)}, color, Px(1.6));
      }
      s += step;
      *along += step;
    }
  }

  void DrawHandles(const GraphKey& key) {
    if (!key.handles || layout_.curves[key.curve].is_hidden) return;
    const ImU32 color = ToIm(colors::kSelected, 0.85f);
    for (const Point& end : *key.handles) {
      list_->AddLine(ToIm(key.at), ToIm(end), color, 1.0f);
      list_->AddCircleFilled(ToIm(end), Px(3.2), color, 12);
    }
  }

  void DrawNames() {
    const Rect& names = layout_.frame.names;
    list_->PushClipRect(UpperLeft(names), LowerRight(names), true);
    list_->AddRectFilled(UpperLeft(names), LowerRight(names), ToIm(theme_.panel));
    for (size_t i = 0; i < layout_.curves.size(); ++i) {
      const GraphCurve& curve = layout_.curves[i];
      const Rect rect = layout_.NameRect(static_cast<int>(i));
      const ImVec2 at = {rect.x + Px(8.0), rect.y + 0.5f * rect.h - Px(5.0)};
      const ImVec2 end = {at.x + Px(10.0), at.y + Px(10.0)};
      const ImU32 color = ToIm(CurveColor(curve.color));
      if (curve.is_hidden) {
        list_->AddRect(at, end, color, Px(2.0));
      } else {
        list_->AddRectFilled(at, end, color, Px(2.0));
      }
      const Rect label = {end.x + Px(7.0), rect.y, rect.right() - end.x - Px(9.0), rect.h};
      DrawLabel(list_, label, curve.name, ToIm(curve.is_hidden ? theme_.faint_text : theme_.text));
    }
    list_->PopClipRect();
  }

  ImDrawList* list_;
  Editor* editor_;
  const Theme& theme_;
  const GraphLayout& layout_;
};

}  // namespace

void DrawGraph(Editor* editor, const Rect& rect) {
  editor->sheet.rect = rect;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  BeginPanel("##graph", rect, editor->theme().panel);
  ImGui::PopStyleVar();
  ImGui::InvisibleButton("##curves", {rect.w, rect.h},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                             ImGuiButtonFlags_MouseButtonRight);
  TakeGraphInput(editor, CurrentGraph(editor));
  // The values stand still as long as something is dragged.
  const GraphLayout layout = CurrentGraph(editor, editor->sheet.fits_values && !editor->has_tool());
  editor->sheet.values = layout.values;
  editor->sheet.curves.clear();
  for (const GraphCurve& curve : layout.curves) editor->sheet.curves.push_back(curve.name);
  GraphPainter(ImGui::GetWindowDrawList(), editor, layout).Draw();
  DrawSheetPopups(editor);
  EndPanel();
}

}  // namespace hazumi::ui
