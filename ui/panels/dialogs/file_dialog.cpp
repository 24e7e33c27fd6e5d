// What the file dialog does; file_dialog_draw.cpp shows it.

#include <filesystem>

#include "ui/panels/dialogs/dialogs.h"

namespace hazumi::ui {

namespace {

// Where the project is, or else the latest one, or else home.
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
  return HomeFolder();
}

std::string FirstName(const Editor& editor) {
  const std::string& path = editor.session().document().path();
  return path.empty() ? WithProjectSuffix(editor.session().project().name) : NameIn(path);
}

std::string ChosenPath(const FileDialogState& files) {
  const std::string path = PathOf(files.folder, files.name, HomeFolder());
  return files.is_save && !files.exports ? WithProjectSuffix(path) : path;
}

// What opening or saving said; the dialog stays if that was an error.
void Finish(const Result<Done>& done, Editor* editor) {
  FileDialogState& files = editor->dialogs.files;
  if (!done.ok()) {
    files.error = TextOf(done.error(), files.is_save ? "file.save" : "file.open");
    return;
  }
  const Then then = files.then;
  if (files.is_save) editor->Say(Tr("Saved."));
  Close(editor);
  DoThen(then, editor);
}

void Save(Editor* editor) {
  const std::string path = ChosenPath(editor->dialogs.files);
  // It was asked before whether what is there may go.
  Finish(editor->Invoke("file.save", {{"path", path}, {"overwrite", true}}), editor);
}

// Without the suffix too, as long as there is no such file.
std::string ExistingPath(const FileDialogState& files) {
  std::error_code unknown;
  const std::string path = ChosenPath(files);
  const bool lacks_suffix = !std::filesystem::exists(path, unknown);
  return lacks_suffix ? WithProjectSuffix(path) : path;
}

// The folder, or for one that is yet to be made the nearest above that is there.
std::string NearestFolder(std::string folder) {
  std::error_code unknown;
  while (!std::filesystem::is_directory(folder, unknown) && folder != ParentOf(folder)) {
    folder = ParentOf(folder);
  }
  return folder;
}

// Back to the export dialog.
void TakeExportPath(Editor* editor) {
  editor->dialogs.exporting.path = ChosenPath(editor->dialogs.files);
  TakeTypedPath(&editor->dialogs.exporting);
  Open(Modal::kExport, editor);
}

// As the project's file will find it.
void TakeMedia(Editor* editor, const char* id) {
  const std::string& project = editor->session().document().path();
  std::filesystem::path path = ChosenPath(editor->dialogs.files);
  if (!project.empty()) {
    path = path.lexically_relative(
        std::filesystem::absolute(project).lexically_normal().parent_path());
  }
  const Result<Done> set = editor->Invoke(id, {{"file", path.string()}});
  if (set.ok()) return Close(editor);
  editor->dialogs.files.error = TextOf(set.error(), id);
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
  if (files.picks_folder) std::erase_if(files.entries, [](const auto& e) { return !e.is_folder; });
  editor->NeedGlyphs(files.folder);
  for (const FileEntry& entry : files.entries) editor->NeedGlyphs(entry.name);
}

void GoToFolder(const std::string& folder, Editor* editor) {
  FileDialogState& files = editor->dialogs.files;
  files.folder = folder;
  files.error.clear();
  files.asks_overwrite = false;
  if (!files.is_save) files.name.clear();
  ReadFolder(editor);
}

void OpenFileDialog(Editor* editor, bool is_save, Then then) {
  FileDialogState& files = editor->dialogs.files;
  files = {};
  files.is_save = is_save;
  files.then = std::move(then);
  if (is_save) files.name = FirstName(*editor);
  GoToFolder(FirstFolder(*editor), editor);
  Open(Modal::kFiles, editor);
}

namespace {

// To choose a file of another kind than projects.
void OpenToChoose(FolderFilter::Kind kind, bool FileDialogState::*what, Editor* editor) {
  OpenFileDialog(editor, false);
  editor->dialogs.files.*what = true;
  editor->dialogs.files.filter.kind = kind;
  ReadFolder(editor);
}

}  // namespace

void OpenImportFileDialog(Editor* editor) {
  OpenToChoose(FolderFilter::Kind::kCharacters, &FileDialogState::imports, editor);
}

void OpenSoundDialog(Editor* editor) {
  OpenToChoose(FolderFilter::Kind::kSounds, &FileDialogState::sounds, editor);
}

void OpenReferenceDialog(Editor* editor) {
  OpenToChoose(FolderFilter::Kind::kReferences, &FileDialogState::references, editor);
}

void OpenMeshDialog(Editor* editor) {
  OpenToChoose(FolderFilter::Kind::kMeshes, &FileDialogState::meshes, editor);
}

void OpenFolderDialog(Editor* editor) {
  FileDialogState& files = editor->dialogs.files;
  files = {};
  files.picks_folder = true;
  const std::string folder = PathOf(HomeFolder(), editor->dialogs.render.folder, HomeFolder());
  GoToFolder(NearestFolder(folder), editor);
  Open(Modal::kFiles, editor);
}

// Where the export dialog's file would be, or where that folder would be.
void OpenExportFileDialog(Editor* editor) {
  const std::string path = PathOf(HomeFolder(), editor->dialogs.exporting.path, HomeFolder());
  OpenFileDialog(editor, true);
  FileDialogState& files = editor->dialogs.files;
  files.exports = true;
  files.filter.kind = FolderFilter::Kind::kMotions;
  files.name = NameIn(path);
  GoToFolder(NearestFolder(ParentOf(path)), editor);
}

void ChooseFolder(Editor* editor) {
  const FileDialogState& files = editor->dialogs.files;
  editor->dialogs.render.folder =
      files.name.empty() ? files.folder : PathOf(files.folder, files.name, HomeFolder());
  Open(Modal::kRender, editor);
}

void LeaveFileDialog(Editor* editor) {
  if (editor->dialogs.files.picks_folder) return Open(Modal::kRender, editor);
  if (editor->dialogs.files.exports) return Open(Modal::kExport, editor);
  Close(editor);
}

void SelectEntry(int entry, Editor* editor) {
  FileDialogState& files = editor->dialogs.files;
  files.selected = entry;
  files.asks_overwrite = false;
  files.error.clear();
  const FileEntry& chosen = files.entries[entry];
  if (!files.is_save || !chosen.is_folder) files.name = chosen.name;
}

void ChooseFile(Editor* editor) {
  FileDialogState& files = editor->dialogs.files;
  files.error.clear();
  const bool is_on_folder = files.selected >= 0 && files.entries[files.selected].is_folder;
  if (!files.is_save && files.selected >= 0) files.name = files.entries[files.selected].name;
  const std::string wanted = is_on_folder ? files.entries[files.selected].name : files.name;
  if (wanted.empty()) return;
  std::error_code unknown;
  const std::string folder = PathOf(files.folder, wanted, HomeFolder());
  if (std::filesystem::is_directory(folder, unknown)) {
    if (!is_on_folder) files.name.clear();
    return GoToFolder(folder, editor);
  }
  if (files.exports) return TakeExportPath(editor);
  if (files.sounds) return TakeMedia(editor, "audio.set");
  if (files.references) return TakeMedia(editor, "reference.set");
  if (files.meshes) {
    return Finish(editor->Invoke("file.add_mesh", {{"path", ExistingPath(files)}}), editor);
  }
  if (files.imports || (!files.is_save && IsOfOtherProgram(wanted))) {
    return OpenImport(ChosenPath(files), editor);
  }
  if (!files.is_save) {
    return Finish(editor->Invoke("file.open", {{"path", ExistingPath(files)}}), editor);
  }
  const std::string path = ChosenPath(files);
  const edit::Document& document = editor->session().document();
  const bool is_own = path == document.path() && !document.is_changed_elsewhere();
  if (std::filesystem::exists(path, unknown) && !is_own) {
    files.asks_overwrite = true;
    return;
  }
  Save(editor);
}

void ConfirmOverwrite(Editor* editor) {
  editor->dialogs.files.asks_overwrite = false;
  Save(editor);
}

}  // namespace hazumi::ui
