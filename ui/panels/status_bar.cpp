#include "ui/panels/panels.h"
#include "ui/panels/status_line.h"
#include "ui/panels/widgets.h"

namespace hazumi::ui {

namespace {

// Returns where it begins [px from the left].
float DrawRight(const Editor& editor, float width) {
  constexpr const char* kBetween = "   |   ";
  std::vector<std::string> parts = StatusParts(editor);
  std::string text;
  // The last ones are left out where they would take more than half of the bar.
  for (const std::string& part : parts) {
    std::string longer = text;
    if (!text.empty()) longer += kBetween;
    longer += part;
    if (!text.empty() && ImGui::CalcTextSize(longer.c_str()).x > 0.55f * width) break;
    text = longer;
  }
  const float left = width - ImGui::CalcTextSize(text.c_str()).x - 10.0f;
  ImGui::SameLine(left);
  ImGui::TextDisabled("%s", text.c_str());
  return left;
}

void DrawLeft(const Editor& editor) {
  const std::string hint = editor.tool_hint(), baking = BakingText(editor);
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
  const float left = DrawRight(*editor, rect.w);
  ImGui::SetCursorPos({ImGui::GetStyle().WindowPadding.x, y});
  ImGui::PushClipRect({rect.x, rect.y}, {rect.x + left - 10.0f, rect.bottom()}, true);
  DrawLeft(*editor);
  ImGui::PopClipRect();
  EndPanel();
}

}  // namespace hazumi::ui
