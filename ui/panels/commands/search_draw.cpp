// The search box.

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "ui/panels/dialogs/parts.h"

namespace hazumi::ui {

namespace {

constexpr int kMostShown = 12;

void MoveSelection(int count, SearchState* search) {
  const int by = (ImGui::IsKeyPressed(kDown) ? 1 : 0) - (ImGui::IsKeyPressed(kUp) ? 1 : 0);
  search->selected = std::clamp(search->selected + by, 0, std::max(0, count - 1));
}

// What was chosen, by click or Enter.
std::optional<Command> DrawFound(const std::vector<Command>& found, const Editor& editor) {
  const SearchState& search = editor.dialogs.search;
  std::optional<Command> chosen;
  for (int i = 0; i < static_cast<int>(found.size()); ++i) {
    ImGui::PushID(i);
    if (ImGui::Selectable(found[i].label.c_str(), i == search.selected)) chosen = found[i];
    Tooltip(HelpOf(found[i].id));
    const std::string key = KeyOf(found[i].id, found[i].parameters);
    if (!key.empty()) {
      ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(key.c_str()).x);
      ImGui::TextDisabled("%s", key.c_str());
    }
    ImGui::PopID();
  }
  const bool can_choose = search.selected < static_cast<int>(found.size());
  if (IsEnterPressed(editor) && can_choose && !editor.dialogs.just_opened)
    chosen = found[search.selected];
  return chosen;
}

}  // namespace

void DrawSearch(Editor* editor) {
  SearchState& search = editor->dialogs.search;
  editor->dialogs.takes_arrows = true;
  ImGui::SetNextItemWidth(-1.0f);
  ImGui::SetKeyboardFocusHere();
  const std::string before = search.query;
  ImGui::InputTextWithHint("##query", Tr("What to do?"), &search.query);
  if (search.query != before) search.selected = 0;
  std::vector<Command> found = Search(AllCommands(), search.query);
  if (found.size() > kMostShown) found.resize(kMostShown);
  if (found.empty()) ImGui::TextDisabled("%s", Tr("Nothing is called so."));
  MoveSelection(static_cast<int>(found.size()), &search);
  const std::optional<Command> chosen = DrawFound(found, *editor);
  if (IsEscapePressed(*editor)) return Close(editor);
  if (!chosen) return;
  Close(editor);
  RunOrAsk(editor, chosen->id, chosen->parameters).ok();  // the status bar says what is refused
}

}  // namespace hazumi::ui
