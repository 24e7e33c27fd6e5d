#include "ui/panels/dope_sheet/bars.h"
#include "ui/panels/dope_sheet/input.h"
#include "ui/panels/dope_sheet/muscle_draw.h"
#include "ui/panels/sheet/drawing.h"
#include "ui/panels/sheet/popups.h"
#include "ui/panels/window/panels.h"

namespace hazumi::ui {

namespace {

class DopeSheetPainter {
 public:
  DopeSheetPainter(ImDrawList* list, Editor* editor, const DopeSheetLayout& layout)
      : list_(list),
        editor_(editor),
        theme_(editor->theme()),
        layout_(layout),
        chosen_(ChosenBar(editor->session().project(), editor->sheet)) {}

  void Draw() {
    const SheetFrame& frame = layout_.frame;
    list_->PushClipRect({frame.rect.x, frame.tracks.y}, LowerRight(frame.rect), true);
    for (size_t i = 0; i < layout_.rows.size(); ++i) DrawBackground(i);
    DrawTimeGrid(list_, *editor_, frame);
    list_->PushClipRect(UpperLeft(frame.tracks), LowerRight(frame.tracks), true);
    for (const RowBar& bar : layout_.bars) DrawBar(bar);
    DrawPaint();
    const auto radius = static_cast<float>(4.2 * frame.scale);
    for (const RowKey& key : layout_.keys) {
      DrawKey(list_, key.at, radius, {key.interpolation, key.type, key.is_selected});
    }
    list_->PopClipRect();
    for (size_t i = 0; i < layout_.rows.size(); ++i) DrawName(i);
    list_->PopClipRect();
    DrawRuler(list_, editor_, frame);
    DrawCornerToggle(list_, *editor_, frame.corner, Tr("Only selected"),
                     editor_->sheet.only_selected);
    DrawBox();
  }

 private:
  float Px(double at_scale_1) const { return static_cast<float>(at_scale_1 * layout_.frame.scale); }

  // Of its hinges: 1 all are selected, less than that some are, 0 none.
  float SelectedShare(const SheetRow& row) const {
    const std::set<std::string>& chosen = editor_->session().selected_joints();
    int num = 0;
    for (const JointIndex j : row.hinges) {
      num += chosen.contains(editor_->session().figure().joint(j).name) ? 1 : 0;
    }
    if (row.object.is_valid()) return row.object == editor_->viewport.selected_object ? 1.0f : 0.0f;
    if (IsOfRoot(row)) return editor_->session().is_root_selected() ? 1.0f : 0.0f;
    if (num == 0) return 0.0f;
    return num == static_cast<int>(row.hinges.size()) ? 1.0f : 0.4f;
  }

  void DrawBackground(size_t row) {
    const Rect& rect = layout_.row_rects[row];
    const Rect tracks = {layout_.frame.tracks.x, rect.y, layout_.frame.tracks.w, rect.h};
    const bool is_odd = row % 2 == 1;
    list_->AddRectFilled(UpperLeft(tracks), LowerRight(tracks),
                         ToIm(is_odd ? theme_.row_odd : theme_.row));
    const float share = SelectedShare(layout_.rows[row]);
    list_->AddRectFilled(UpperLeft(tracks), LowerRight(tracks), ToIm(theme_.accent, 0.16f * share));
  }

  void DrawName(size_t row) {
    const SheetRow& of = layout_.rows[row];
    const SheetFrame& frame = layout_.frame;
    const Rect rect = {frame.names.x, layout_.row_rects[row].y, frame.names.w,
                       layout_.row_rects[row].h};
    const bool is_head = of.depth == 0;
    list_->AddRectFilled(UpperLeft(rect), LowerRight(rect),
                         ToIm(is_head ? theme_.header : theme_.panel));
    list_->AddRectFilled(UpperLeft(rect), LowerRight(rect),
                         ToIm(theme_.accent, 0.55f * SelectedShare(of)));
    list_->AddLine({rect.x, rect.bottom() - 0.5f}, {rect.right(), rect.bottom() - 0.5f},
                   ToIm(theme_.window, 0.5f));
    const float indent = rect.x + Px(6.0 + 12.0 * of.depth);
    const float y = rect.y + 0.5f * rect.h;
    if (of.has_parts) DrawArrow(indent, y, of.is_open);
    DrawLabel(list_, {indent + Px(13.0), rect.y, rect.right() - indent - Px(17.0), rect.h}, of.name,
              ToIm(of.depth == 2 ? theme_.faint_text : theme_.text));
  }

  void DrawArrow(float x, float y, bool is_open) {
    const float r = Px(3.6);
    const ImU32 color = ToIm(theme_.faint_text);
    if (is_open) {
      list_->AddTriangleFilled({x, y - 0.6f * r}, {x + 2.0f * r, y - 0.6f * r}, {x + r, y + r},
                               color);
    } else {
      list_->AddTriangleFilled({x + 0.4f * r, y - r}, {x + 2.0f * r, y}, {x + 0.4f * r, y + r},
                               color);
    }
  }

  std::string TextOf(const RowBar& bar) const {
    std::string title = TitleOf(editor_->session().project(), bar.ref);
    if (bar.num_held == bar.num_hinges) return title;
    return title + "  " + std::to_string(bar.num_held) + "/" + std::to_string(bar.num_hinges);
  }

  bool IsMuted(const BarRef& bar) const {
    return bar.kind == BarKind::kRegion && editor_->session().project().regions[bar.index].mute;
  }

  SrgbColor ColorOf(const RowBar& bar) const {
    if (IsMuted(bar.ref)) return theme_.faint_text;
    return TypeOf(bar.ref.kind).color.value_or(theme_.faint_text);
  }

  void DrawBar(const RowBar& bar) {
    const Rect& rect = bar.rect;
    const SrgbColor color = ColorOf(bar);
    const bool is_whole = bar.num_held == bar.num_hinges;
    const bool is_chosen = chosen_ && *chosen_ == bar.ref;
    list_->AddRectFilled(UpperLeft(rect), LowerRight(rect), ToIm(color, is_whole ? 0.42f : 0.22f),
                         Px(3.0));
    if (bar.ref.kind == BarKind::kRegion && !IsMuted(bar.ref)) {
      DrawHatch(list_, rect, layout_.frame.tracks, ToIm(color, 0.55f), Px(7.0));
    }
    list_->AddRect(UpperLeft(rect), LowerRight(rect),
                   is_chosen ? ToIm(colors::kSelected) : ToIm(color, 0.95f), Px(3.0), 0,
                   is_chosen ? Px(1.6) : 1.0f);
    DrawMuscle(bar);
    if (bar.touches) DrawTouch(bar);
    DrawBlend(bar);
    if (layout_.rows[bar.row].depth == 0 && rect.h >= Px(12.0)) DrawTitle(bar);
  }

  // How strong its spring is, as high as it is filled; rows of joints say what moves each.
  void DrawMuscle(const RowBar& bar) {
    if (bar.ref.kind != BarKind::kRegion || bar.num_held == 0 || IsMuted(bar.ref)) return;
    if (bar.muscle.spring >= 0) {
      const Rect strip = StripOf(bar);
      list_->AddRectFilled(UpperLeft(strip), LowerRight(strip), ToIm(colors::kMuscle, 0.5f),
                           Px(3.0), ImDrawFlags_RoundCornersBottom);
      list_->AddLine(UpperLeft(strip), {strip.right(), strip.y}, ToIm(colors::kMuscle), Px(2.0));
    }
    const float left = std::max(bar.rect.x, layout_.frame.tracks.x) + Px(8.0);
    const float right = std::min(bar.rect.right(), layout_.frame.tracks.right());
    const float radius = std::min(Px(5.0), 0.5f * bar.rect.h);
    if (layout_.rows[bar.row].depth == 0 || right - left < 3.0f * radius) return;
    const Point center = {left + radius, bar.rect.y + 0.5f * bar.rect.h};
    list_->AddRectFilled({left - Px(2.0), center.y - radius - 1.0f},
                         {left + 2.0f * radius + Px(2.0), center.y + radius + 1.0f},
                         ToIm(theme_.panel, 0.72f), Px(2.0));
    DrawMuscleMark(list_, center, radius, bar.muscle.kind, ToIm(theme_.text));
  }

  // A ball on the ground, at the end of the bar, where it covers no muscle and no title.
  void DrawTouch(const RowBar& bar) {
    const float right = std::min(bar.rect.right(), layout_.frame.tracks.right()) - Px(7.0);
    const float left = std::max(bar.rect.x, layout_.frame.tracks.x) + Px(8.0);
    const float radius = std::min(Px(4.0), 0.35f * bar.rect.h);
    if (right - left < 7.0f * radius) return;
    const ImVec2 c = {right - radius, bar.rect.bottom() - 2.2f * radius - 1.0f};
    const float ground = c.y + 1.3f * radius;
    list_->AddRectFilled({c.x - 1.6f * radius, c.y - 1.4f * radius},
                         {c.x + 1.6f * radius, ground + 0.6f * radius}, ToIm(theme_.panel, 0.72f),
                         Px(2.0));
    list_->AddCircleFilled(c, radius, ToIm(theme_.text), 12);
    list_->AddLine({c.x - 1.4f * radius, ground}, {c.x + 1.4f * radius, ground}, ToIm(theme_.text),
                   Px(1.3));
  }

  // A tail that fades out to where the joints are back on their keys at the earliest.
  void DrawBlend(const RowBar& bar) {
    if (bar.ref.kind != BarKind::kRegion || IsMuted(bar.ref)) return;
    const ProjectRegion& region = editor_->session().project().regions[bar.ref.index];
    const float end = layout_.frame.axis.XOf(1.0 * region.last_frame + region.blend_frames);
    const float right = std::min(end, layout_.frame.tracks.right());
    if (right <= bar.rect.right()) return;
    const ImU32 near = ToIm(colors::kDynamics, 0.5f), far = ToIm(colors::kDynamics, 0.05f);
    list_->AddRectFilledMultiColor({bar.rect.right(), bar.rect.y}, {right, bar.rect.bottom()}, near,
                                   far, far, near);
  }

  // Where there is no room for "held: r_toe" the joint alone.
  std::string TextOf(const RowBar& bar, float room) const {
    const std::string text = TextOf(bar);
    const size_t colon = text.find(": ");
    const bool is_short = ImGui::CalcTextSize(text.c_str()).x > room;
    const bool has_joint = bar.ref.kind != BarKind::kRegion && colon != std::string::npos;
    return is_short && has_joint ? text.substr(colon + 2) : text;
  }

  // Above the keys; it stays in sight while the bar begins before the left edge.
  void DrawTitle(const RowBar& bar) {
    const Rect& rect = bar.rect;
    const float left = std::max(rect.x, layout_.frame.tracks.x) + Px(6.0);
    const Rect label = {left, rect.y, rect.right() - left - Px(3.0), std::min(rect.h, Px(15.0))};
    const std::string text = TextOf(bar, label.w);
    const float width = std::min(ImGui::CalcTextSize(text.c_str()).x, label.w);
    if (width < Px(8.0)) return;
    if (bar.ref.kind == BarKind::kRegion) {
      list_->AddRectFilled({label.x - Px(3.0), label.y + 1.0f},
                           {label.x + width + Px(3.0), label.bottom()}, ToIm(theme_.panel, 0.72f),
                           Px(2.0));
    }
    DrawLabel(list_, label, text, ToIm(theme_.text));
  }

  // What would become a region.
  void DrawPaint() {
    const std::optional<SheetState::Paint>& paint = editor_->sheet.paint;
    if (!paint) return;
    const int num = static_cast<int>(layout_.rows.size());
    for (int row = paint->first_row; row <= std::min(paint->last_row, num - 1); ++row) {
      if (layout_.rows[row].refs.empty()) continue;
      const Rect& on = layout_.row_rects[row];
      const float left = layout_.frame.axis.XOf(paint->first_frame);
      const Rect rect = {left, on.y + 1.0f, layout_.frame.axis.XOf(paint->last_frame) - left + 1.0f,
                         on.h - 2.0f};
      list_->AddRectFilled(UpperLeft(rect), LowerRight(rect), ToIm(colors::kDynamics, 0.3f));
      DrawHatch(list_, rect, layout_.frame.tracks, ToIm(colors::kDynamics), Px(7.0));
      list_->AddRect(UpperLeft(rect), LowerRight(rect), ToIm(colors::kSelected));
    }
  }

  void DrawBox() {
    const std::optional<Rect>& box = editor_->sheet.box;
    if (!box) return;
    list_->AddRectFilled(UpperLeft(*box), LowerRight(*box), IM_COL32(255, 255, 255, 24));
    list_->AddRect(UpperLeft(*box), LowerRight(*box), IM_COL32(255, 255, 255, 150));
  }

  ImDrawList* list_;
  Editor* editor_;
  const Theme& theme_;
  const DopeSheetLayout& layout_;
  std::optional<BarRef> chosen_;
};

}  // namespace

void DrawDopeSheet(Editor* editor, const Rect& rect) {
  editor->sheet.rect = rect;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  BeginPanel("##dope_sheet", rect, editor->theme().panel);
  ImGui::PopStyleVar();
  ImGui::InvisibleButton("##rows", {rect.w, rect.h},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonMiddle |
                             ImGuiButtonFlags_MouseButtonRight);
  const auto lay_out = [&] {
    return LayOutDopeSheet(editor->session(), editor->sheet, rect, editor->settings.scale);
  };
  DopeSheetLayout layout = lay_out();
  if (TakeDopeSheetInput(editor, layout)) layout = lay_out();
  DopeSheetPainter(ImGui::GetWindowDrawList(), editor, layout).Draw();
  DrawSheetPopups(editor);
  EndPanel();
}

}  // namespace hazumi::ui
