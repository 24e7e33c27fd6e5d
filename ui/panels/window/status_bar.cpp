#include "ui/panels/window/panels.h"
#include "ui/panels/window/status_line.h"
#include "ui/panels/window/widgets.h"

namespace hazumi::ui {

namespace {

float WidthOf(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }

// The last parts are left out where they would take more than `room`; the first one stays unless a
// tool needs the room. Returns where it begins [px from the left].
float DrawRight(const Editor& editor, float width, float room) {
  constexpr const char* kBetween = "   |   ";
  std::string text;
  for (const std::string& part : StatusParts(editor)) {
    std::string longer = text;
    if (!text.empty()) longer += kBetween;
    longer += part;
    if ((editor.has_tool() || !text.empty()) && WidthOf(longer) > room) break;
    text = std::move(longer);
  }
  const float left = width - WidthOf(text) - 10.0f;
  ImGui::SameLine(left);
  ImGui::TextDisabled("%s", text.c_str());
  return left;
}

void DrawLeft(const Editor& editor, const std::string& hint) {
  const std::string baking = BakingText(editor);
  if (!hint.empty()) {
    ImGui::TextUnformatted(hint.c_str());
  } else if (!baking.empty()) {
    ImGui::TextUnformatted(baking.c_str());
  } else if (editor.message.is_error) {
    ImGui::TextColored(ToIm4(editor.theme().warning), "! %s", editor.message.text.c_str());
    Tooltip(editor.message.text);
  } else {
    ImGui::TextUnformatted(editor.message.text.c_str());
  }
}

}  // namespace

void DrawStatusBar(Editor* editor, const Rect& rect) {
  BeginPanel("##status", rect, editor->theme().header);
  const float y = 0.5f * (rect.h - ImGui::GetTextLineHeight());
  ImGui::SetCursorPosY(y);
  ImGui::Dummy({0.0f, 0.0f});
  const float margin = ImGui::GetStyle().WindowPadding.x + 20.0f;
  const std::string hint = FittingHint(editor->tool_hint(), rect.w - margin, WidthOf);
  const float room = hint.empty() ? 0.55f * rect.w : rect.w - margin - WidthOf(hint);
  const float left = DrawRight(*editor, rect.w, room);
  ImGui::SetCursorPos({ImGui::GetStyle().WindowPadding.x, y});
  ImGui::PushClipRect({rect.x, rect.y}, {rect.x + left - 10.0f, rect.bottom()}, true);
  DrawLeft(*editor, hint);
  ImGui::PopClipRect();
  EndPanel();
}

}  // namespace hazumi::ui
