#include "ui/panels/graph/torque_draw.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/base/filled.h"
#include "engine/base/text.h"
#include "ui/panels/sheet/drawing.h"

namespace hazumi::ui {

using render::FromHex;

namespace {

class TorquePainter {
 public:
  TorquePainter(ImDrawList* list, const Editor& editor, const GraphLayout& layout)
      : list_(list),
        editor_(editor),
        theme_(editor.theme()),
        layout_(layout),
        panel_(*layout.torque) {}

  void Draw() {
    const Rect& rect = panel_.rect;
    SheetFrame frame = layout_.frame;
    frame.tracks = rect;
    list_->AddRectFilled(UpperLeft(rect), LowerRight(rect), ToIm(theme_.row));
    DrawTimeGrid(list_, editor_, frame);
    list_->PushClipRect(UpperLeft(rect), LowerRight(rect), true);
    DrawBand();
    DrawValues();
    for (const TorqueCurve& curve : panel_.curves) DrawCurve(curve);
    list_->AddLine({rect.x, rect.y}, {rect.right(), rect.y}, ToIm(theme_.line), Px(1.5));
    DrawNote();
    list_->PopClipRect();
  }

 private:
  float Px(double at_scale_1) const { return static_cast<float>(at_scale_1 * layout_.frame.scale); }
  ImVec2 At(double frame, double torque) const {
    return {layout_.frame.axis.XOf(frame), panel_.YOf(torque)};
  }

  // Green is what muscles can give, red what they cannot; lines between the two.
  void DrawBand() {
    const ImU32 inside = ToIm(colors::kInterpolated, 0.16f), edge = ToIm(colors::kInterpolated);
    const ImU32 outside = ToIm(colors::kSinking, 0.10f);
    for (size_t i = 0; i + 1 < panel_.band.size(); ++i) {
      const StrengthBand &a = panel_.band[i], &b = panel_.band[i + 1];
      const ImVec2 high_a = At(a.frame, a.high), high_b = At(b.frame, b.high);
      const ImVec2 low_a = At(a.frame, a.low), low_b = At(b.frame, b.low);
      list_->AddQuadFilled(high_a, high_b, low_b, low_a, inside);
      const float top = panel_.rect.y, bottom = panel_.rect.bottom();
      list_->AddQuadFilled({high_a.x, top}, {high_b.x, top}, {high_b.x, std::max(high_b.y, top)},
                           {high_a.x, std::max(high_a.y, top)}, outside);
      list_->AddQuadFilled({low_a.x, std::min(low_a.y, bottom)},
                           {low_b.x, std::min(low_b.y, bottom)}, {low_b.x, bottom},
                           {low_a.x, bottom}, outside);
      list_->AddLine(high_a, high_b, edge, Px(1.2));
      list_->AddLine(low_a, low_b, edge, Px(1.2));
    }
  }

  void DrawValues() {
    const Rect& rect = panel_.rect;
    for (const Tick& tick : ValueTicks(panel_.values.low, panel_.values.high, rect.h, Px(16.0))) {
      const float y = std::round(panel_.YOf(tick.value)) + 0.5f;
      const double value = std::abs(tick.value) < 1e-9 ? 0.0 : tick.value;
      list_->AddLine({rect.x, y}, {rect.right(), y}, ToIm(theme_.line, value == 0.0 ? 1.0f : 0.4f));
      list_->AddText({rect.x + Px(4.0), std::round(y - ImGui::GetFontSize())},
                     ToIm(theme_.faint_text), (FormatShort(value) + " N m").c_str());
    }
  }

  // Beyond what its muscles can give it is thick and red, with dots.
  void DrawCurve(const TorqueCurve& curve) {
    const GraphCurve& of = layout_.curves[static_cast<size_t>(curve.curve)];
    const ImU32 color = ToIm(CurveColor(of.color)), beyond = ToIm(colors::kSinking);
    const bool has_band = of.hinge == panel_.band_of;
    for (size_t i = 0; i < curve.points.size(); ++i) {
      const auto& [frame, torque] = curve.points[i];
      const bool is_beyond = has_band && IsBeyond(frame, torque);
      if (i + 1 < curve.points.size()) {
        const auto& [next, then] = curve.points[i + 1];
        const bool both = is_beyond && IsBeyond(next, then);
        list_->AddLine(At(frame, torque), At(next, then), both ? beyond : color,
                       Px(both ? 2.6 : 1.6));
      }
      if (is_beyond) list_->AddCircleFilled(At(frame, torque), Px(3.0), beyond, 12);
    }
  }

  bool IsBeyond(double frame, double torque) const {
    const auto at = std::find_if(panel_.band.begin(), panel_.band.end(),
                                 [&](const StrengthBand& of) { return of.frame == frame; });
    return at != panel_.band.end() && (torque > at->high || torque < at->low);
  }

  std::string Note() const {
    if (!panel_.band_of) return "";
    const std::string& name = editor_.session().figure().joint(*panel_.band_of).name;
    if (!editor_.effort.is_there()) {
      return editor_.effort.is_busy() ? Tr("Torques are being computed")
                                      : Tr("No torques are known");
    }
    if (panel_.band.empty()) return Filled(Tr("How strong %s is, is not known"), name.c_str());
    return Filled(Tr("green: what %s can give"), name.c_str());
  }

  void DrawNote() {
    const std::string note = Note();
    const ImVec2 size = ImGui::CalcTextSize(note.c_str());
    list_->AddText({panel_.rect.right() - size.x - Px(8.0), panel_.rect.y + Px(4.0)},
                   ToIm(theme_.faint_text), note.c_str());
  }

  ImDrawList* list_;
  const Editor& editor_;
  const Theme& theme_;
  const GraphLayout& layout_;
  const TorquePanel& panel_;
};

}  // namespace

SrgbColor CurveColor(int index) {
  static constexpr std::array<SrgbColor, 10> kColors = {
      FromHex(0xe5484d), FromHex(0x46a758), FromHex(0x3b82f6), FromHex(0xd9922b),
      FromHex(0xa259d9), FromHex(0x12a5a5), FromHex(0xdb5aa0), FromHex(0x8a9a2f),
      FromHex(0x7f7fe8), FromHex(0xa87b5a)};
  return kColors[static_cast<size_t>(index) % kColors.size()];
}

void DrawTorque(ImDrawList* list, const Editor& editor, const GraphLayout& layout) {
  TorquePainter(list, editor, layout).Draw();
}

}  // namespace hazumi::ui
