#include "ui/panels/sheet/name_field.h"

#include <imgui.h>
#include <imgui_stdlib.h>

namespace hazumi::ui {

// ImGui keeps what is typed as long as it is.
std::optional<std::string> NameField(Editor* editor, const std::string& name) {
  std::string typed = name;
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const bool is_entered = ImGui::InputText(
      "##name", &typed, ImGuiInputTextFlags_AutoSelectAll | ImGuiInputTextFlags_EnterReturnsTrue);
  if (ImGui::IsItemEdited()) editor->NeedGlyphs(typed);
  const bool is_done = is_entered || ImGui::IsItemDeactivatedAfterEdit();
  if (is_entered) ImGui::CloseCurrentPopup();
  if (!is_done || typed.empty() || typed == name) return std::nullopt;
  return typed;
}

}  // namespace hazumi::ui
