// What lies in the corners of the viewport.

#include <imgui.h>

#include <algorithm>

#include "ui/panels/commands/actions.h"
#include "ui/panels/viewport/actions.h"
#include "ui/panels/viewport/layout.h"
#include "ui/panels/viewport/marks.h"
#include "ui/panels/viewport/overlays.h"
#include "ui/panels/viewport/scene.h"
#include "ui/panels/window/widgets.h"

namespace hazumi::ui {

namespace {

std::string ViewName(const Editor& editor) {
  const ViewportState& state = editor.viewport;
  if (state.through_project_camera && editor.session().project().camera) return Tr("Camera");
  const char* side = SideOf(state.camera);
  const char* kind = Tr(state.camera.is_orthographic ? "orthographic" : "perspective");
  return *side ? std::string(Tr(side)) + ", " + kind : std::string(Tr("View")) + ", " + kind;
}

struct Toggle {
  const char* name;  // of view.overlay; empty: it is the live mirror
  const char* label;
  const char* help;
  bool is_on;
};

std::vector<Toggle> TogglesOf(const Editor& editor) {
  std::vector<Toggle> toggles = {{"", "Mirror", "Poses both sides at once", editor.mirrors_poses}};
  for (const OverlaySwitch& overlay : OverlaySwitches()) {
    toggles.push_back(
        {overlay.name, overlay.label, overlay.help, editor.viewport.overlays.*overlay.is_on});
  }
  return toggles;
}

void DrawToggle(Editor* editor, const Toggle& toggle, const Rect& rect) {
  ImGui::SetCursorScreenPos({rect.x, rect.y});
  ImGui::PushID(toggle.label);
  if (ImGui::InvisibleButton("##toggle", {rect.w, rect.h})) {
    const bool is_overlay = toggle.name[0] != '\0';
    is_overlay ? editor->Do("view.overlay", {{"name", toggle.name}})
               : editor->Do("pose.live_mirror");
  }
  const bool is_hovered = ImGui::IsItemHovered();
  Tooltip(Tr(toggle.help));
  ImGui::PopID();
  const float round = 0.25f * rect.h;
  const SrgbColor& fill = toggle.is_on ? editor->theme().accent : colors::kShade;
  const float alpha = (toggle.is_on ? 0.85f : 0.45f) + (is_hovered ? 0.15f : 0.0f);
  Canvas()->AddRectFilled({rect.x, rect.y}, {rect.right(), rect.bottom()}, ToIm(fill, alpha),
                          round);
  const ImVec2 size = ImGui::CalcTextSize(Tr(toggle.label));
  Canvas()->AddText({rect.x + 0.5f * (rect.w - size.x), rect.y + 0.5f * (rect.h - size.y)},
                    ToIm(colors::kWhite, toggle.is_on ? 1.0f : 0.6f), Tr(toggle.label));
}

std::vector<Rect> RectsOf(const std::vector<Toggle>& toggles, const Rect& viewport, double scale) {
  std::vector<float> widths;
  widths.reserve(toggles.size());
  for (const Toggle& toggle : toggles) {
    widths.push_back(ImGui::CalcTextSize(Tr(toggle.label)).x + static_cast<float>(14.0 * scale));
  }
  const float height = ImGui::GetTextLineHeight() + static_cast<float>(6.0 * scale);
  return LayOutToggles(viewport, widths, height, scale);
}

// The upper edge of a text so wide in the upper left corner: below the buttons that are in its way.
float TopOfCaption(const Editor& editor, const Rect& viewport, float edge, float width) {
  float top = viewport.y + edge;
  const std::vector<Toggle> toggles = TogglesOf(editor);
  for (const Rect& toggle : RectsOf(toggles, viewport, editor.settings.scale)) {
    const bool is_in_way = toggle.x < viewport.x + 2.0f * edge + width;
    if (is_in_way) top = std::max(top, toggle.bottom() + 0.5f * edge);
  }
  return top;
}

}  // namespace

void DrawToggles(Editor* editor, const Rect& rect) {
  const std::vector<Toggle> toggles = TogglesOf(*editor);
  const std::vector<Rect> rects = RectsOf(toggles, rect, editor->settings.scale);
  for (size_t i = 0; i < toggles.size(); ++i) DrawToggle(editor, toggles[i], rects[i]);
}

void DrawCaption(const Editor& editor, const Rect& rect) {
  const float edge = static_cast<float>(10.0 * editor.settings.scale);
  const float line = ImGui::GetTextLineHeightWithSpacing();
  const std::string first = ViewName(editor);
  const float top = TopOfCaption(editor, rect, edge, ImGui::CalcTextSize(first.c_str()).x);
  DrawShadedText({rect.x + edge, top}, first.c_str());
  std::string second = std::string(Tr("Frame")) + " " + std::to_string(FrameShown(editor));
  const std::vector<GroupIndex> joints = SelectedJoints(editor.session());
  if (editor.session().is_root_selected()) {
    second += "   " + editor.session().figure().root_name();
  } else if (joints.size() == 1) {
    second += "   " + editor.session().figure().group(joints[0]).name;
  }
  if (joints.empty()) second += "   " + NameOfSelectedObject(editor);
  DrawShadedText({rect.x + edge, top + line}, second.c_str());
}

void DrawAxisCross(const Editor& editor, const View& view) {
  constexpr SrgbColor kColors[] = {colors::kAxisX, colors::kAxisY, colors::kAxisZ};
  constexpr const char* kLetters[] = {"X", "Y", "Z"};
  const float scale = static_cast<float>(editor.settings.scale);
  const AxisCross cross = LayOutAxisCross(view, scale);
  for (const CrossAxis& axis : cross.axes) {
    const ImU32 color = ToIm(kColors[axis.axis]);
    Canvas()->AddLine(ToIm(cross.center), ToIm(axis.end), color, 2.0f * scale);
    Canvas()->AddCircleFilled(ToIm(axis.end), 8.0f * scale, color, 20);
    const ImVec2 size = ImGui::CalcTextSize(kLetters[axis.axis]);
    Canvas()->AddText({axis.end.x - 0.5f * size.x, axis.end.y - 0.5f * size.y},
                      ToIm(colors::kShade), kLetters[axis.axis]);
  }
}

// Outside of what a render would show it is darker.
void DrawCameraBorder(const Editor& editor, const Rect& rect) {
  const Project& project = editor.session().project();
  if (!editor.viewport.through_project_camera || !project.camera) return;
  const Rect b = Bordered(*project.camera, kPictureAspect, rect).border;
  const ImU32 shade = ToIm(colors::kShade, 0.5f);
  Canvas()->AddRectFilled({rect.x, rect.y}, {rect.right(), b.y}, shade);
  Canvas()->AddRectFilled({rect.x, b.bottom()}, {rect.right(), rect.bottom()}, shade);
  Canvas()->AddRectFilled({rect.x, b.y}, {b.x, b.bottom()}, shade);
  Canvas()->AddRectFilled({b.right(), b.y}, {rect.right(), b.bottom()}, shade);
  Canvas()->AddRect({b.x, b.y}, {b.right(), b.bottom()}, ToIm(colors::kWhite, 0.8f));
}

}  // namespace hazumi::ui
