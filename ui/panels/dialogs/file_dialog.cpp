// What the file dialog does; file_dialog_draw.cpp shows it.

#include <filesystem>

#include "ui/panels/dialogs/dialogs.h"

namespace hazumi::ui {

namespace {

// Where the project is, or else the latest one, or else where the program was started from a shell,
// or else home.
std::string FirstFolder(const Editor& editor) {
  const std::string& path = editor.session().document().path();
  std::error_code unknown;
  if (!path.empty()) {
    std::string folder = ParentOf(std::filesystem::absolute(path).string());
    if (std::filesystem::is_directory(folder, unknown)) return folder;
  }
  for (const std::string& file : editor.settings.recent_files) {
    if (std::filesystem::is_directory(ParentOf(file), unknown)) return ParentOf(file);
  }
  const std::string start = std::filesystem::current_path(unknown).string();
  return unknown || start == "/" ? HomeFolder() : start;
}

std::string FirstName(const Editor& editor) {
  const std::string& path = editor.session().document().path();
  return path.empty() ? WithProjectSuffix(editor.session().project().name) : NameIn(path);
}

// The folder, or for one that is yet to be made the nearest above that is there.
std::string NearestFolder(std::string folder) {
  std::error_code unknown;
  while (!std::filesystem::is_directory(folder, unknown) && folder != ParentOf(folder)) {
    folder = ParentOf(folder);
  }
  return folder;
}

}  // namespace

void ReadFolder(Editor* editor) {
  FileDialogState& files = editor->dialogs.files;
  files.selected = -1;
  files.entries.clear();
  Result<std::vector<FileEntry>> entries = ListFolder(files.folder, files.filter);
  if (!entries.ok()) {
    files.error = entries.error().ToString();
    return;
  }
  files.entries = std::move(entries).value();
  editor->NeedGlyphs(files.folder);
  for (const FileEntry& entry : files.entries) editor->NeedGlyphs(entry.name);
}

void GoToFolder(const std::string& folder, Editor* editor) {
  FileDialogState& files = editor->dialogs.files;
  files.folder = folder;
  files.error.clear();
  files.asks_overwrite = false;
  if (!files.purpose->writes) files.name.clear();
  ReadFolder(editor);
}

namespace {

void OpenFileDialogIn(const std::string& folder, const std::string& name,
                      const FilePurpose& purpose, Then then, Editor* editor) {
  FileDialogState& files = editor->dialogs.files;
  files = {};
  files.purpose = &purpose;
  files.filter.wanted = purpose.wanted;
  files.then = std::move(then);
  files.name = name;
  GoToFolder(folder, editor);
  Open(Modal::kFiles, editor);
}

}  // namespace

void OpenFileDialog(Editor* editor, const FilePurpose& purpose, Then then) {
  const std::string name = purpose.writes ? FirstName(*editor) : "";
  OpenFileDialogIn(FirstFolder(*editor), name, purpose, std::move(then), editor);
}

void OpenFolderDialog(Editor* editor) {
  const std::string folder = PathOf(HomeFolder(), editor->dialogs.render.folder, HomeFolder());
  OpenFileDialogIn(NearestFolder(folder), "", kChooseFolder, nullptr, editor);
}

// Where the export dialog's file would be, or where that folder would be.
void OpenExportFileDialog(Editor* editor) {
  const std::string path = PathOf(HomeFolder(), editor->dialogs.exporting.path, HomeFolder());
  OpenFileDialogIn(NearestFolder(ParentOf(path)), NameIn(path), kChooseExport, nullptr, editor);
}

void OpenOntoFileDialog(Editor* editor) {
  const std::string path = PathOf(HomeFolder(), editor->dialogs.exporting.onto, HomeFolder());
  OpenFileDialogIn(NearestFolder(ParentOf(path)), NameIn(path), kChooseOnto, nullptr, editor);
}

void LeaveFileDialog(Editor* editor) {
  const Modal back = editor->dialogs.files.purpose->back;
  back == Modal::kNone ? Close(editor) : Open(back, editor);
}

void SelectEntry(int entry, Editor* editor) {
  FileDialogState& files = editor->dialogs.files;
  files.selected = entry;
  files.asks_overwrite = false;
  files.error.clear();
  const FileEntry& chosen = files.entries[entry];
  if (!files.purpose->writes || !chosen.is_folder) files.name = chosen.name;
}

void ChooseFile(Editor* editor) {
  FileDialogState& files = editor->dialogs.files;
  files.error.clear();
  const bool is_on_folder = files.selected >= 0 && files.entries[files.selected].is_folder;
  if (!files.purpose->writes && files.selected >= 0)
    files.name = files.entries[files.selected].name;
  const std::string wanted = is_on_folder ? files.entries[files.selected].name : files.name;
  if (wanted.empty()) return;
  std::error_code unknown;
  const std::string folder = PathOf(files.folder, wanted, HomeFolder());
  if (std::filesystem::is_directory(folder, unknown)) {
    if (!is_on_folder) files.name.clear();
    return GoToFolder(folder, editor);
  }
  files.purpose->take(editor);
}

}  // namespace hazumi::ui
