#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <ctime>

#include "engine/base/utf8.h"
#include "ui/panels/dialogs/parts.h"

namespace hazumi::ui {

namespace {

std::string DateText(std::int64_t seconds) {
  const std::time_t time = seconds;
  std::tm local;
  char text[32];
  if (!localtime_r(&time, &local)) return "";
  std::strftime(text, sizeof text, "%Y-%m-%d  %H:%M", &local);
  return text;
}

// Tab leads to the first of them, arrows to the others.
bool DrawShelf(int number, const std::string& label, bool is_here, const std::string& path,
               Editor* editor) {
  const TabStops stops(number == 0);
  ImGui::PushID(number);
  const bool is_chosen = ListLine(label, is_here);
  editor->dialogs.takes_enter |= HasKeyboard();
  ImGui::PopID();
  Tooltip(path);
  return is_chosen;
}

void DrawShelves(Editor* editor) {
  ImGui::TextDisabled("%s", Tr("Places"));
  int i = 0;
  // Nothing is saved among the examples.
  const bool writes = editor->dialogs.files.purpose->writes;
  const std::string examples = writes ? "" : ExamplesBeside(ProgramPath());
  for (const Shelf& shelf : Shelves(HomeFolder(), editor->settings.recent_files, examples)) {
    const bool is_here = shelf.path == editor->dialogs.files.folder;
    if (DrawShelf(i++, Tr(shelf.label.c_str()), is_here, shelf.path, editor)) {
      GoToFolder(shelf.path, editor);
    }
  }
  const FileDialogState& files = editor->dialogs.files;
  if (files.purpose->writes || !files.purpose->wanted || editor->settings.recent_files.empty())
    return;
  ImGui::Spacing();
  ImGui::TextDisabled("%s", Tr("Recent files"));
  const std::vector<std::string> recent = editor->settings.recent_files;
  for (const std::string& file : recent) {
    if (!DrawShelf(i++, NameIn(file), false, file, editor)) continue;
    GoToFolder(ParentOf(file), editor);
    editor->dialogs.files.name = file;
    ChooseFile(editor);
  }
}

void DrawTop(Editor* editor) {
  FileDialogState& files = editor->dialogs.files;
  if (ImGui::ArrowButton("##up", ImGuiDir_Up)) GoToFolder(ParentOf(files.folder), editor);
  Tooltip(Tr("The folder above"), "Backspace");
  ImGui::SameLine();
  ImGui::AlignTextToFramePadding();
  const auto width_of = [](const char* label) {
    const ImGuiStyle& style = ImGui::GetStyle();
    return ImGui::GetFrameHeight() + style.ItemInnerSpacing.x + ImGui::CalcTextSize(label).x;
  };
  const float files_width =
      !files.purpose->wanted ? 0.0f : width_of(Tr("All files")) + ImGui::GetStyle().ItemSpacing.x;
  const float choices_width = width_of(Tr("Newest first")) + files_width;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x - choices_width;
  ImGui::PushClipRect(at, {at.x + width, at.y + Px(*editor, 40)}, true);
  ImGui::TextUnformatted(ValidUtf8(files.folder).c_str());
  ImGui::PopClipRect();
  Tooltip(files.folder);
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - choices_width);
  bool is_newest = files.filter.order == FileOrder::kNewest;
  bool is_changed = ImGui::Checkbox(Tr("Newest first"), &is_newest);
  Tooltip(Tr("Sorts by the time of the last change instead of the name."));
  files.filter.order = is_newest ? FileOrder::kNewest : FileOrder::kName;
  if (files.purpose->wanted) {
    ImGui::SameLine();
    is_changed |= ImGui::Checkbox(Tr("All files"), &files.filter.all_files);
    Tooltip(Tr("Also shows files that are no projects."));
  }
  if (is_changed) ReadFolder(editor);
}

void DrawRow(const FileEntry& entry, bool is_selected, float date_x) {
  const std::string name = ValidUtf8(entry.name) + (entry.is_folder ? "/" : "");
  ImGui::Selectable(name.c_str(), is_selected, ImGuiSelectableFlags_AllowDoubleClick);
  if (entry.is_folder) return;
  const ImVec2 min = ImGui::GetItemRectMin();
  const std::string date = DateText(entry.changed);
  ImGui::GetWindowDrawList()->AddText({min.x + date_x, min.y + ImGui::GetStyle().ItemSpacing.y / 2},
                                      ImGui::GetColorU32(ImGuiCol_TextDisabled), date.c_str());
}

// The list; double click or Enter opens.
void DrawList(Editor* editor) {
  FileDialogState& files = editor->dialogs.files;
  const float date_x = ImGui::GetContentRegionAvail().x -
                       ImGui::CalcTextSize("2026-12-31  23:59").x - Px(*editor, 16);
  std::optional<int> chosen;
  if (files.entries.empty()) {
    ImGui::TextDisabled("%s", Tr(files.purpose->nothing));
  }
  for (int i = 0; i < static_cast<int>(files.entries.size()); ++i) {
    ImGui::PushID(i);
    DrawRow(files.entries[i], i == files.selected, date_x);
    if (ImGui::IsItemClicked()) SelectEntry(i, editor);
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) chosen = i;
    const bool moved = ImGui::IsKeyPressed(kUp) || ImGui::IsKeyPressed(kDown);
    if (i == files.selected && moved) ImGui::SetScrollHereY();
    ImGui::PopID();
  }
  if (chosen) ChooseFile(editor);
}

// Tab has led to one of the places or to what is above: both were drawn before.
bool HasLeftName() {
  const ImGuiContext& context = *ImGui::GetCurrentContext();
  return context.NavIdIsAlive && !context.NavDisableHighlight && context.ActiveId == 0;
}

// Up and Down, as long as the keyboard is at the name.
void MoveSelection(Editor* editor) {
  FileDialogState& files = editor->dialogs.files;
  editor->dialogs.takes_arrows = !HasLeftName();
  if (!editor->dialogs.takes_arrows) return;
  const int count = static_cast<int>(files.entries.size());
  const int by = (ImGui::IsKeyPressed(kDown) ? 1 : 0) - (ImGui::IsKeyPressed(kUp) ? 1 : 0);
  if (by == 0 || count == 0) return;
  const int next = files.selected < 0 ? (by > 0 ? 0 : count - 1) : files.selected + by;
  SelectEntry(std::clamp(next, 0, count - 1), editor);
}

// Which entry of which folder is selected, as a number.
int PlaceOf(const FileDialogState& files) {
  constexpr size_t kPrime = 1'000'000'007;
  return static_cast<int>(std::hash<std::string>()(files.folder) % kPrime) + files.selected;
}

void NoteNameField(const FileDialogState& files) {
  ImGui::GetStateStorage()->SetInt(ImGui::GetID("##place"), PlaceOf(files));
}

// A name that the list gave, not the keyboard, needs a new field: one that is edited keeps its own.
int NameFieldNumber(const FileDialogState& files) {
  ImGuiStorage* storage = ImGui::GetStateStorage();
  const ImGuiID number = ImGui::GetID("##number");
  if (storage->GetInt(ImGui::GetID("##place")) != PlaceOf(files)) {
    storage->SetInt(number, storage->GetInt(number) + 1);
    NoteNameField(files);
  }
  return storage->GetInt(number);
}

// In the dialog to open, what is typed selects the first entry that begins so.
void DrawName(Editor* editor) {
  FileDialogState& files = editor->dialogs.files;
  const bool was_empty = files.name.empty();
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(Tr("Name"));
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1.0f);
  if (editor->dialogs.takes_arrows && !ImGui::IsAnyItemActive() &&
      !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    ImGui::SetKeyboardFocusHere();
  }
  const std::string before = files.name;
  const std::string id = "##name" + std::to_string(NameFieldNumber(files));
  if (ImGui::InputText(id.c_str(), &files.name, ImGuiInputTextFlags_AutoSelectAll) &&
      files.name != before) {
    files.error.clear();
    files.asks_overwrite = false;
    files.selected = files.purpose->writes ? -1 : FirstBeginningWith(files.entries, files.name);
    editor->NeedGlyphs(files.name);
    NoteNameField(files);
  }
  if (was_empty && ImGui::IsKeyPressed(kBackspace)) GoToFolder(ParentOf(files.folder), editor);
}

// What is said above the buttons.
std::string Trouble(const FileDialogState& files) {
  if (!files.asks_overwrite) return files.error;
  return NameIn(WithProjectSuffix(files.name)) + ": " + Tr("this file exists already.");
}

void DrawAskOverwrite(Editor* editor) {
  DrawError(Trouble(editor->dialogs.files), editor->theme());
  const int clicked = DrawButtons(*editor, {{Tr("Overwrite"), ""}, {Tr("Cancel"), ""}});
  if (clicked == 0) editor->dialogs.files.purpose->take(editor);
  if (clicked == 1 || IsEscapePressed(*editor)) editor->dialogs.files.asks_overwrite = false;
}

void DrawFooter(Editor* editor) {
  FileDialogState& files = editor->dialogs.files;
  if (files.asks_overwrite) return DrawAskOverwrite(editor);
  DrawError(Trouble(files), editor->theme());
  const FilePurpose& purpose = *files.purpose;
  const ButtonText choose = {Tr(purpose.button), Tr(purpose.button_help)};
  const int clicked = DrawButtons(*editor, {choose, {Tr("Cancel"), ""}});
  if (clicked == 0) purpose.wanted ? ChooseFile(editor) : purpose.take(editor);
  if (clicked == 1 || IsEscapePressed(*editor)) LeaveFileDialog(editor);
}

}  // namespace

void DrawFileDialog(Editor* editor) {
  const FileDialogState& files = editor->dialogs.files;
  if (*files.purpose->advice) ImGui::TextDisabled("%s", Tr(files.purpose->advice));
  DrawTop(editor);
  const float bottom = ImGui::GetFrameHeightWithSpacing() * 2.0f + HeightOfError(Trouble(files)) +
                       ImGui::GetStyle().ItemSpacing.y;
  ImGui::BeginChild("##places", {Px(*editor, 150), -bottom}, false, ImGuiWindowFlags_NavFlattened);
  DrawShelves(editor);
  ImGui::EndChild();
  MoveSelection(editor);
  ImGui::SameLine();
  ImGui::PushStyleColor(ImGuiCol_ChildBg, ToIm4(editor->theme().row_odd));
  {
    const TabStops stops(false);  // arrows of the name lead through it
    ImGui::BeginChild("##entries", {0.0f, -bottom}, true);
    DrawList(editor);
    ImGui::EndChild();
  }
  ImGui::PopStyleColor();
  DrawName(editor);
  const TabStops stops(false);  // Enter and Esc are enough
  DrawFooter(editor);
}

}  // namespace hazumi::ui
