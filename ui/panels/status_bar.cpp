#include "ui/panels/panels.h"
#include "ui/panels/widgets.h"

namespace hazumi::ui {

void DrawStatusBar(Editor* editor, const Rect& rect) {
  const Theme& theme = editor->theme();
  BeginPanel("##status", rect, theme.header);
  ImGui::SetCursorPosY(0.5f * (rect.h - ImGui::GetTextLineHeight()));
  const std::string hint = editor->tool_hint();
  if (!hint.empty()) {
    ImGui::TextUnformatted(hint.c_str());
  } else if (editor->message.is_error) {
    ImGui::TextColored(ToIm4(colors::kChanged), "! %s", editor->message.text.c_str());
  } else {
    ImGui::TextUnformatted(editor->message.text.c_str());
  }
  EndPanel();
}

}  // namespace hazumi::ui
