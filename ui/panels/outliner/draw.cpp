#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>

#include "ui/edit/operators/keys/at_frame.h"
#include "ui/panels/outliner/input.h"
#include "ui/panels/properties/layout.h"
#include "ui/panels/window/panels.h"
#include "ui/panels/window/widgets.h"

namespace hazumi::ui {

namespace {

constexpr SrgbColor kLeftColor = render::FromHex(0x4fa3e3);
constexpr SrgbColor kRightColor = render::FromHex(0xe07a5f);
constexpr SrgbColor kMiddleColor = render::FromHex(0xd9c04f);

SrgbColor ColorOf(BodySide side) {
  if (side == BodySide::kLeft) return kLeftColor;
  return side == BodySide::kRight ? kRightColor : kMiddleColor;
}

bool IsJoint(const OutlinerRow& row) {
  return row.kind == OutlinerRowKind::kJoint || row.kind == OutlinerRowKind::kHinge;
}

// Whether a region moves it at the current frame; of a joint, any of its hinges.
bool IsMoved(Editor* editor, const OutlinerRow& row) {
  edit::Session& session = editor->session();
  const Animation* animation = session.animation();
  if (!animation || !IsJoint(row)) return false;
  const Figure& figure = session.figure();
  if (row.kind == OutlinerRowKind::kHinge) {
    const auto hinge = figure.FindJoint(row.name);
    return hinge && edit::IsSwung(*animation, *hinge, session.frame());
  }
  const JointGroup& joint = figure.group(*figure.FindGroup(row.name));
  for (int j = joint.first.value(); j <= joint.last().value(); ++j) {
    if (edit::IsSwung(*animation, JointIndex(j), session.frame())) return true;
  }
  return false;
}

void DrawBackground(Editor* editor, const OutlinerRow& row, size_t index, const Rect& rect) {
  const Theme& theme = editor->theme();
  const edit::Session& session = editor->session();
  ImDrawList* list = ImGui::GetWindowDrawList();
  const auto fill = [&](const SrgbColor& color, float alpha) {
    list->AddRectFilled({rect.x, rect.y}, {rect.right(), rect.bottom()}, ToIm(color, alpha));
  };
  fill(index % 2 == 0 ? theme.row : theme.row_odd, 1.0f);
  const Share share = ShareOf(row, session.selected_joints(), session.figure());
  const bool is_active = row.kind != OutlinerRowKind::kHinge && row.name == editor->side.active;
  if (share == Share::kAll) fill(theme.accent, 0.85f);
  if (share == Share::kSome) fill(theme.accent, 0.4f);
  if (is_active && !IsSelectable(row)) fill(theme.accent, 0.85f);
  if (rect.Contains(FromIm(ImGui::GetIO().MousePos)) && ImGui::IsWindowHovered()) {
    fill(theme.text, 0.06f);
  }
}

// What comes before the label: a dot for the side, or a sign for the kind. Its width is returned.
float DrawSign(Editor* editor, const OutlinerRow& row, Point center, float size) {
  const Theme& theme = editor->theme();
  ImDrawList* list = ImGui::GetWindowDrawList();
  const ImU32 faint = ToIm(theme.faint_text);
  const ImVec2 low(center.x - 0.28f * size, center.y - 0.28f * size);
  const ImVec2 high(center.x + 0.28f * size, center.y + 0.28f * size);
  switch (row.kind) {
    case OutlinerRowKind::kHeading:
      return 0.0f;
    case OutlinerRowKind::kRoot:
      DrawDiamond(list, center, 0.32f * size, ToIm(kMiddleColor), true);
      break;
    case OutlinerRowKind::kJoint:
      DrawDot(list, center, 0.25f * size, ToIm(ColorOf(row.side)));
      break;
    case OutlinerRowKind::kHinge:
      list->AddCircle(ToIm(center), 0.2f * size, ToIm(ColorOf(row.side)), 0, 1.2f);
      break;
    case OutlinerRowKind::kItem:
      if (row.thing == Thing::kObject) {
        list->AddRectFilled(low, high, faint, 1.0f);
      } else if (row.thing == Thing::kHeldObject) {
        list->AddCircle(ToIm(center), 0.28f * size, faint, 0, 1.5f);
      } else {
        DrawDiamond(list, center, 0.28f * size, faint, false);
      }
      break;
    case OutlinerRowKind::kCamera:
      list->AddRectFilled(low, {center.x + 0.1f * size, high.y}, faint, 1.0f);
      list->AddTriangleFilled({center.x + 0.1f * size, center.y}, {high.x, low.y}, high, faint);
      break;
  }
  return size;
}

// Hatched where a region moves the joint now. `right`: where it ends [px].
void DrawMoved(Editor* editor, const OutlinerRow& row, float right, float middle) {
  if (!IsMoved(editor, row)) return;
  const float size = ImGui::GetFontSize();
  const edit::Session& session = editor->session();
  const bool is_selected = ShareOf(row, session.selected_joints(), session.figure()) == Share::kAll;
  const ImU32 color = ToIm(is_selected ? editor->theme().text : colors::kDynamics);
  const Rect mark = {right - 1.2f * size, middle - 0.3f * size, size, 0.6f * size};
  ImDrawList* list = ImGui::GetWindowDrawList();
  DrawHatch(list, mark, color);
  list->AddRect({mark.x, mark.y}, {mark.right(), mark.bottom()}, color);
}

// Shown where they say something, and where the mouse is.
void DrawSwitches(Editor* editor, const OutlinerRow& row, size_t index,
                  const OutlinerPlace& place) {
  const edit::Session& session = editor->session();
  const Theme& theme = editor->theme();
  const Point mouse = FromIm(ImGui::GetIO().MousePos);
  const bool is_hovered = ImGui::IsWindowHovered() && place.RowRect(index).Contains(mouse);
  const float radius = 0.36f * ImGui::GetFontSize();
  const auto draw = [&](const Rect& rect, const std::set<std::string>& names, auto sign,
                        const char* help) {
    const bool is_on = ShareOf(row, names, session.figure()) == Share::kAll;
    if (!is_on && !is_hovered) return;
    const bool is_under = rect.Contains(mouse) && ImGui::IsWindowHovered();
    const ImU32 color = ToIm(is_on || is_under ? theme.text : theme.faint_text);
    sign(Point{rect.x + 0.5f * rect.w, rect.y + 0.5f * rect.h}, radius, color, is_on);
    if (is_under) TooltipOf(rect, help);
  };
  ImDrawList* list = ImGui::GetWindowDrawList();
  draw(
      place.Eye(index), session.hidden_joints(),
      [&](Point c, float r, ImU32 color, bool is_hidden) {
        DrawEye(list, c, r, color, !is_hidden);
      },
      Tr("Hides the joint's mark, or shows it (H, Alt+H)"));
  draw(
      place.Lock(index), session.locked_joints(),
      [&](Point c, float r, ImU32 color, bool is_locked) {
        DrawLock(list, c, r, color, is_locked);
      },
      Tr("Locks the joint against posing, or unlocks it"));
}

void DrawRow(Editor* editor, const OutlinerRow& row, size_t index, const OutlinerPlace& place) {
  const Theme& theme = editor->theme();
  ImDrawList* list = ImGui::GetWindowDrawList();
  const Rect rect = place.RowRect(index);
  DrawBackground(editor, row, index, rect);
  const Rect triangle = place.Disclosure(row, index);
  const float size = ImGui::GetFontSize(), middle = rect.y + 0.5f * rect.h;
  if (row.has_rows) {
    DrawTriangle(list, {triangle.x + 0.5f * triangle.w, middle}, 0.26f * size,
                 ToIm(theme.faint_text), row.is_open);
  }
  float x = triangle.right();
  x += DrawSign(editor, row, {x + 0.4f * size, middle}, size);
  const bool is_faint = row.kind == OutlinerRowKind::kHeading;
  const bool is_named = IsSelectable(row) || row.kind == OutlinerRowKind::kItem;
  const char* label = is_named ? row.label.c_str() : Tr(row.label.c_str());
  list->AddText({x, middle - 0.5f * size}, ToIm(is_faint ? theme.faint_text : theme.text), label);
  if (!IsSelectable(row)) return;
  DrawMoved(editor, row, place.Eye(index).x, middle);
  DrawSwitches(editor, row, index, place);
}

ClickMode ClickModeNow() {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.KeyCtrl) return ClickMode::kToggle;
  return io.KeyShift ? ClickMode::kExtend : ClickMode::kOnly;
}

void DrawRows(Editor* editor, const std::vector<OutlinerRow>& rows) {
  const auto scale = static_cast<float>(editor->settings.scale);
  OutlinerPlace place;
  place.row_height = std::round(20.0f * scale);
  place.indent = std::round(11.0f * scale);
  place.scroll = ImGui::GetScrollY();
  const ImVec2 at = ImGui::GetWindowPos(), room = ImGui::GetWindowSize();
  place.list = {at.x, at.y, ImGui::GetContentRegionAvail().x, room.y};
  for (size_t i = 0; i < rows.size(); ++i) {
    const Rect rect = place.RowRect(i);
    if (rect.bottom() > place.list.y && rect.y < place.list.bottom()) {
      DrawRow(editor, rows[i], i, place);
    }
  }
  ImGui::Dummy({1.0f, static_cast<float>(rows.size()) * place.row_height});
  if (!ImGui::IsWindowHovered()) return;
  const auto hit = HitOutliner(rows, place, FromIm(ImGui::GetIO().MousePos));
  if (hit && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    ClickOutliner(editor, rows, *hit, ClickModeNow());
  }
}

}  // namespace

void DrawOutliner(Editor* editor, const Rect& rect) {
  BeginPanel("##outliner", rect, editor->theme().panel);
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::InputTextWithHint("##search", Tr("Search joints"), &editor->side.search);
  const edit::Session& session = editor->session();
  const std::vector<OutlinerRow> rows =
      OutlinerRows(session.figure(), session.project(), editor->side);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  ImGui::BeginChild("##rows");
  if (rows.empty()) ImGui::TextDisabled("%s", Tr("Nothing has this name."));
  if (!rows.empty()) DrawRows(editor, rows);
  ImGui::EndChild();
  ImGui::PopStyleVar();
  EndPanel();
}

}  // namespace hazumi::ui
