// The properties: tabs along the left edge, and the section that was chosen.

#include <algorithm>

#include "ui/panels/problems/problems.h"
#include "ui/panels/properties/layout.h"
#include "ui/panels/properties/sections.h"
#include "ui/panels/window/panels.h"
#include "ui/panels/window/widgets.h"

namespace hazumi::ui {

namespace {

const char* NameOf(Section section) {
  switch (section) {
    case Section::kPose:
      return "Pose";
    case Section::kPoses:
      return "Poses";
    case Section::kRegion:
      return "Region";
    case Section::kScene:
      return "Scene";
    case Section::kProject:
      return "Project";
    case Section::kProblems:
      return "Problems";
    case Section::kSweep:
      return "Sweep";
  }
  return "";
}

// A bent limb, four pictures, a hatched bar, a box, a sheet of paper, a warning sign, a
// table.
void DrawIcon(Section section, Point c, float r, ImU32 color) {
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float line = std::max(1.0f, 0.2f * r);
  const ImVec2 low(c.x - r, c.y - r), high(c.x + r, c.y + r);
  if (section == Section::kPose) {
    const ImVec2 knee(c.x + 0.6f * r, c.y - 0.1f * r);
    list->AddLine({c.x - 0.5f * r, c.y - r}, knee, color, line);
    list->AddLine(knee, {c.x - 0.5f * r, c.y + r}, color, line);
    DrawDot(list, {c.x - 0.5f * r, c.y - r}, 0.3f * r, color);
    DrawDot(list, FromIm(knee), 0.3f * r, color);
    DrawDot(list, {c.x - 0.5f * r, c.y + r}, 0.3f * r, color);
  } else if (section == Section::kPoses) {
    for (const float x : {-1.0f, 0.15f}) {
      for (const float y : {-1.0f, 0.15f}) {
        list->AddRect({c.x + x * r, c.y + y * r}, {c.x + (x + 0.85f) * r, c.y + (y + 0.85f) * r},
                      color, 1.0f, 0, line);
      }
    }
  } else if (section == Section::kRegion) {
    const Rect bar = {c.x - r, c.y - 0.6f * r, 2.0f * r, 1.2f * r};
    DrawHatch(list, bar, color);
    list->AddRect({bar.x, bar.y}, {bar.right(), bar.bottom()}, color);
  } else if (section == Section::kScene) {
    list->AddQuad({c.x, low.y}, {high.x, c.y - 0.5f * r}, {c.x, c.y}, {low.x, c.y - 0.5f * r},
                  color, line);
    list->AddLine({low.x, c.y - 0.5f * r}, {low.x, c.y + 0.5f * r}, color, line);
    list->AddLine({high.x, c.y - 0.5f * r}, {high.x, c.y + 0.5f * r}, color, line);
    list->AddLine({c.x, c.y}, {c.x, high.y}, color, line);
    list->AddLine({low.x, c.y + 0.5f * r}, {c.x, high.y}, color, line);
    list->AddLine({high.x, c.y + 0.5f * r}, {c.x, high.y}, color, line);
  } else if (section == Section::kProblems) {
    list->AddTriangle({c.x, low.y}, {high.x, high.y - 0.1f * r}, {low.x, high.y - 0.1f * r}, color,
                      line);
    list->AddLine({c.x, c.y - 0.35f * r}, {c.x, c.y + 0.3f * r}, color, line);
    DrawDot(list, {c.x, c.y + 0.62f * r}, 0.14f * r, color);
  } else if (section == Section::kSweep) {
    for (const float x : {-1.0f, -0.3f, 0.4f}) {
      for (const float y : {-1.0f, -0.3f, 0.4f}) {
        list->AddRectFilled({c.x + x * r, c.y + y * r},
                            {c.x + (x + 0.55f) * r, c.y + (y + 0.55f) * r}, color);
      }
    }
  } else {
    list->AddRect({c.x - 0.75f * r, low.y}, {c.x + 0.75f * r, high.y}, color, 1.0f, 0, line);
    for (const float y : {-0.4f, 0.05f, 0.5f}) {
      list->AddLine({c.x - 0.4f * r, c.y + y * r}, {c.x + 0.4f * r, c.y + y * r}, color, line);
    }
  }
}

void DrawTabs(Editor* editor, const PropertiesLayout& layout) {
  const Theme& theme = editor->theme();
  ImDrawList* list = ImGui::GetWindowDrawList();
  const Point mouse = FromIm(ImGui::GetIO().MousePos);
  std::optional<Section> hovered;
  if (ImGui::IsWindowHovered()) hovered = TabAt(layout, mouse);
  if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) editor->side.section = *hovered;
  for (size_t i = 0; i < layout.tabs.size(); ++i) {
    const auto section = static_cast<Section>(i);
    const Rect& tab = layout.tabs[i];
    const bool is_on = section == editor->side.section;
    const SrgbColor& back = is_on ? theme.panel : theme.header;
    list->AddRectFilled({tab.x + 2.0f, tab.y}, {tab.right(), tab.bottom()}, ToIm(back), 4.0f,
                        ImDrawFlags_RoundCornersLeft);
    const bool is_bright = is_on || (hovered && *hovered == section);
    const bool warns = section == Section::kProblems && HasProblems(editor);
    const SrgbColor& sign = warns ? colors::kChanged : is_bright ? theme.text : theme.faint_text;
    DrawIcon(section, {tab.x + 0.5f * tab.w + 1.0f, tab.y + 0.5f * tab.h}, 0.26f * tab.h,
             ToIm(sign));
  }
  if (hovered) TooltipOf(layout.tabs[static_cast<size_t>(*hovered)], Tr(NameOf(*hovered)));
}

void DrawSection(Editor* editor) {
  switch (editor->side.section) {
    case Section::kPose:
      return DrawPoseSection(editor);
    case Section::kPoses:
      return DrawPosesSection(editor);
    case Section::kRegion:
      return DrawRegionSection(editor);
    case Section::kScene:
      return DrawSceneSection(editor);
    case Section::kProject:
      return DrawProjectSection(editor);
    case Section::kProblems:
      return DrawProblemsSection(editor);
    case Section::kSweep:
      return DrawSweepSection(editor);
  }
}

}  // namespace

void DrawProperties(Editor* editor, const Rect& rect) {
  const PropertiesLayout layout = LayOutProperties(rect, editor->settings.scale);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
  BeginPanel("##properties", rect, editor->theme().header);
  DrawTabs(editor, layout);
  ImGui::PopStyleVar();
  const Rect& content = layout.content;
  ImGui::SetCursorScreenPos({content.x, content.y});
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ToIm4(editor->theme().panel));
  ImGui::BeginChild(NameOf(editor->side.section), {content.w, content.h}, false,
                    ImGuiWindowFlags_AlwaysUseWindowPadding);
  const float scale = static_cast<float>(editor->settings.scale);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(4.0f * scale, 3.0f * scale));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(5.0f * scale, 2.0f * scale));
  DrawSection(editor);
  ImGui::PopStyleVar(2);
  ImGui::EndChild();
  ImGui::PopStyleColor();
  EndPanel();
}

}  // namespace hazumi::ui
