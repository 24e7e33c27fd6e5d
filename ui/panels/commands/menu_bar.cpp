#include "ui/panels/commands/actions.h"
#include "ui/panels/commands/menus.h"
#include "ui/panels/dialogs/dialogs.h"
#include "ui/panels/window/panels.h"
#include "ui/panels/window/widgets.h"

namespace hazumi::ui {

namespace {

void DrawRecentFiles(Editor* editor) {
  const std::vector<std::string> files = editor->settings.recent_files;
  const bool is_open = ImGui::BeginMenu(Tr("Open recent"), !files.empty());
  if (!is_open) return Tooltip(Tr("Projects that were opened or saved last."));
  for (const std::string& file : files) {
    editor->NeedGlyphs(file);
    if (ImGui::MenuItem((NameIn(file) + "##" + file).c_str())) {
      editor->Do("app.open", {{"path", file}});
    }
    Tooltip(file);
  }
  ImGui::EndMenu();
}

// What was undone is above what was done; the mark is where the document is.
void DrawHistory(Editor* editor) {
  constexpr size_t kMost = 24;  // of each
  const edit::Document& document = editor->session().document();
  std::vector<std::string> redo = document.redo_labels(), undo = document.undo_labels();
  const bool is_open = ImGui::BeginMenu(Tr("Undo history"), !redo.empty() || !undo.empty());
  if (!is_open) return Tooltip(Tr("Steps that were done and undone; goes back and forth to one."));
  for (size_t i = std::min(redo.size(), kMost); i > 0; --i) {
    ImGui::PushID(static_cast<int>(i));
    ImGui::PushStyleColor(ImGuiCol_Text, ToIm4(editor->theme().faint_text));
    if (ImGui::MenuItem(Tr(redo[i - 1].c_str()))) editor->Do("edit.redo", {{"steps", i}});
    ImGui::PopStyleColor();
    ImGui::PopID();
  }
  for (size_t i = 0; i < std::min(undo.size(), kMost); ++i) {
    ImGui::PushID(-1 - static_cast<int>(i));
    const bool is_now = i == 0;
    if (ImGui::MenuItem(Tr(undo[i].c_str()), nullptr, is_now) && !is_now) {
      editor->Do("edit.undo", {{"steps", i}});
    }
    ImGui::PopID();
  }
  if (undo.size() <= kMost) {
    const bool is_now = undo.empty();
    if (ImGui::MenuItem(Tr("As it was opened"), nullptr, is_now) && !is_now) {
      editor->Do("edit.undo", {{"steps", undo.size()}});
    }
  }
  ImGui::EndMenu();
}

void DrawSelectionSets(Editor* editor) {
  const std::vector<ProjectSelectionSet> sets = editor->session().project().selection_sets;
  const bool is_open = ImGui::BeginMenu(Tr("Selection sets"), !sets.empty());
  if (!is_open) return Tooltip(HelpOf("select.set"));
  for (const ProjectSelectionSet& set : sets) {
    editor->NeedGlyphs(set.name);
    if (ImGui::MenuItem((set.name + "##set").c_str())) {
      editor->Do("select.set", {{"name", set.name}});
    }
  }
  ImGui::EndMenu();
}

void DrawAction(Editor* editor, const MenuEntry& entry) {
  const std::string label = LabelOf(entry, *editor);
  const std::string key = KeyOf(entry.id, entry.parameters);
  const bool is_on = IsOn(*editor, entry).value_or(false);
  const bool can_do = CanDo(*editor, entry.id);
  if (ImGui::MenuItem(label.c_str(), key.empty() ? nullptr : key.c_str(), is_on, can_do)) {
    RunOrAsk(editor, entry.id, entry.parameters).ok();  // what is refused, the status bar says
  }
  Tooltip(HelpOf(entry.id), "", /*even_disabled=*/true);
}

void DrawEntries(Editor* editor, const std::vector<MenuEntry>& entries);

void DrawEntry(Editor* editor, const MenuEntry& entry) {
  if (!entry.id && !entry.label) return ImGui::Separator();
  if (entry.id && std::string(entry.id) == "app.open") return DrawRecentFiles(editor);
  if (!entry.id && entry.entries.empty()) return DrawHistory(editor);
  if (entry.id && std::string(entry.id) == "select.set") return DrawSelectionSets(editor);
  if (entry.id) return DrawAction(editor, entry);
  if (!ImGui::BeginMenu(Tr(entry.label))) return;
  DrawEntries(editor, entry.entries);
  ImGui::EndMenu();
}

void DrawEntries(Editor* editor, const std::vector<MenuEntry>& entries) {
  for (const MenuEntry& entry : entries) DrawEntry(editor, entry);
}

}  // namespace

void DrawMenuBar(Editor* editor, const Rect&) {
  if (!ImGui::BeginMainMenuBar()) return;
  DrawEntries(editor, AllMenus());
  ImGui::EndMainMenuBar();
}

}  // namespace hazumi::ui
