// The manual, the sheet of keys, About and the card of first steps.

#include <algorithm>

#include "engine/base/version.h"
#include "ui/panels/commands/menus.h"
#include "ui/panels/dialogs/manual.h"
#include "ui/panels/dialogs/parts.h"

namespace hazumi::ui {

namespace {

void DrawHeading(const char* text, const Theme& theme) {
  ImGui::Spacing();
  ImGui::TextColored(ToIm4(theme.heading), "%s", text);
  ImGui::PushStyleColor(ImGuiCol_Separator, ToIm4(theme.line));
  ImGui::Separator();
  ImGui::PopStyleColor();
}

void DrawKey(const std::string& key, const std::string& does) {
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", key.c_str());
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(does.c_str());
}

void DrawMouse(Place place) {
  const auto middle = [](const char* with) { return with + std::string(Tr("middle button")); };
  if (place == Place::kViewport) {
    DrawKey(middle(""), Tr("Turn the view"));
    DrawKey(middle("Shift+"), Tr("Move the view"));
    DrawKey(Tr("wheel"), Tr("Nearer or farther"));
    DrawKey(Tr("right button"), Tr("What can be done with what is there"));
  }
  if (place == Place::kSheet) {
    DrawKey(middle(""), Tr("Move the view"));
    DrawKey("Ctrl+" + std::string(Tr("wheel")), Tr("More or fewer frames"));
  }
}

void DrawKeys(const Theme& theme) {
  for (const Place place : {Place::kAnywhere, Place::kViewport, Place::kSheet}) {
    DrawHeading((std::string(Tr("Keys")) + ": " + LabelOf(place)).c_str(), theme);
    const std::string id = "##keys" + std::to_string(static_cast<int>(place));
    if (!ImGui::BeginTable(id.c_str(), 4, ImGuiTableFlags_SizingStretchProp)) continue;
    DrawMouse(place);
    for (const Shortcut& shortcut : AllShortcuts()) {
      if (shortcut.chord.key == kNoKey || shortcut.place != place) continue;
      DrawKey(NameOf(shortcut.chord), LabelOf(shortcut));
    }
    ImGui::EndTable();
  }
}

void DrawStep(int step, bool is_done, bool is_next, const Theme& theme) {
  const StepText& text = TextOfStep(step);
  const SrgbColor& color = is_done   ? colors::kInterpolated
                           : is_next ? theme.text
                                     : theme.faint_text;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float size = ImGui::GetTextLineHeight();
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddRect({at.x, at.y + 1.0f}, {at.x + size - 2.0f, at.y + size - 1.0f}, ToIm(color), 2.0f);
  if (is_done) {
    list->AddLine({at.x + 0.2f * size, at.y + 0.5f * size},
                  {at.x + 0.4f * size, at.y + 0.75f * size}, ToIm(color), 2.0f);
    list->AddLine({at.x + 0.4f * size, at.y + 0.75f * size},
                  {at.x + 0.75f * size, at.y + 0.25f * size}, ToIm(color), 2.0f);
  }
  ImGui::Dummy({size, size});
  ImGui::SameLine();
  ImGui::TextColored(ToIm4(color), "%d. %s", step + 1, Tr(text.title));
  if (!is_next) return;
  ImGui::Indent(size + ImGui::GetStyle().ItemSpacing.x);
  ImGui::TextWrapped("%s", Tr(text.how));
  ImGui::Unindent(size + ImGui::GetStyle().ItemSpacing.x);
}

// Of a child window in which there is nothing but text.
void ScrollByKeys() {
  const float line = 2.0f * ImGui::GetTextLineHeightWithSpacing();
  const float page = std::max(line, ImGui::GetWindowHeight() - line);
  const float last = ImGui::GetScrollMaxY();
  float y = ImGui::GetScrollY();
  const auto on = [&](int key, float by) { y += ImGui::IsKeyPressed(key) ? by : 0.0f; };
  on(kDown, line);
  on(kUp, -line);
  on(kPageDown, page);
  on(kPageUp, -page);
  on(kEnd, last);
  on(kHome, -last);
  y = std::clamp(y, 0.0f, last);
  if (y != ImGui::GetScrollY()) ImGui::SetScrollY(y);
}

// The first one that is not done is told at length.
void DrawSteps(const Editor& editor) {
  const auto ticks = editor.dialogs.first_steps.ticks();
  const auto next = std::find(ticks.begin(), ticks.end(), false) - ticks.begin();
  for (int i = 0; i < kNumFirstSteps; ++i) DrawStep(i, ticks[i], i == next, editor.theme());
  ImGui::Spacing();
  if (next == kNumFirstSteps) {
    ImGui::TextWrapped("%s", Tr("That was a throw. Help > Manual tells more."));
  }
  ImGui::PushStyleColor(ImGuiCol_Text, ToIm4(editor.theme().faint_text));
  ImGui::TextWrapped("%s", Tr("Or at once: click a wrist, then Scene > Add ball puts a ball into "
                              "that hand, and T throws it onto the spot under the mouse. J jumps "
                              "there."));
  ImGui::PopStyleColor();
}

}  // namespace

void DrawManual(Editor* editor) {
  editor->dialogs.takes_arrows = true;
  ImGui::BeginChild("##manual", {0.0f, -ImGui::GetFrameHeightWithSpacing()});
  ScrollByKeys();
  for (const ManualPart& part : ManualParts()) {
    DrawHeading(Tr(part.title), editor->theme());
    for (const char* paragraph : part.paragraphs) {
      ImGui::TextWrapped("%s", Tr(paragraph));
      ImGui::Spacing();
    }
  }
  DrawKeys(editor->theme());
  ImGui::EndChild();
  if (DrawButtons(*editor, {{Tr("Close"), ""}}) == 0 || IsEscapePressed(*editor)) Close(editor);
}

void DrawAbout(Editor* editor) {
  ImGui::Text("Hazumi %s", kVersion);
  ImGui::TextWrapped("%s", Tr("Keyframe animation in which joints can let go: a dynamics region "
                              "moves them by their own inertia."));
  ImGui::Spacing();
  ImGui::TextDisabled("%s", Tr("Licence: see the file LICENSE."));
  ImGui::TextDisabled("Dear ImGui %s, GLFW, OpenAL Soft, Mesa, Eigen, nlohmann/json, libpng",
                      IMGUI_VERSION);
  ImGui::Spacing();
  if (DrawButtons(*editor, {{Tr("Close"), ""}}) == 0 || IsEscapePressed(*editor)) Close(editor);
}

void DrawFirstSteps(Editor* editor, const Rect& window) {
  const Rect& view = editor->viewport.rect;
  const float margin = Px(*editor, 12), width = Px(*editor, 300);
  const float right = view.w > 0.0f ? view.right() : window.right();
  const float bottom = view.h > 0.0f ? view.bottom() : window.bottom();
  ImGui::SetNextWindowPos({right - margin, bottom - margin}, ImGuiCond_Always, {1.0f, 1.0f});
  ImGui::SetNextWindowSize({width, 0.0f});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, Px(*editor, 6));
  bool stays = true;
  const std::string title = std::string(Tr("First steps")) + "###first_steps";
  ImGui::Begin(title.c_str(), &stays,
               ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  DrawSteps(*editor);
  const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  editor->dialogs.first_steps_card = {at.x, at.y, size.x, size.y};
  ImGui::End();
  ImGui::PopStyleVar();
  if (!stays) editor->Do("help.first_steps", {{"on", false}});
}

}  // namespace hazumi::ui
