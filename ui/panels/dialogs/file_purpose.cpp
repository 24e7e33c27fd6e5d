#include "ui/panels/dialogs/file_purpose.h"

#include <filesystem>

#include "ui/panels/dialogs/dialogs.h"

namespace hazumi::ui {

namespace {

std::string ChosenPath(const FileDialogState& files) {
  return PathOf(files.folder, files.name, HomeFolder());
}

// The dialog stays if that was an error, which it shows in the operator's words.
bool Did(const char* id, const Json& parameters, Editor* editor) {
  const Result<Done> done = editor->Invoke(id, parameters);
  if (!done.ok()) editor->dialogs.files.error = TextOf(done.error(), id);
  if (done.ok()) Close(editor);
  return done.ok();
}

void Import(Editor* editor) { OpenImport(ChosenPath(editor->dialogs.files), editor); }

// Without the suffix too, as long as there is no such file.
void OpenProject(Editor* editor) {
  const std::string path = ChosenPath(editor->dialogs.files);
  if (IsOfOtherProgram(path)) return Import(editor);
  std::error_code unknown;
  const bool lacks_suffix = !std::filesystem::exists(path, unknown);
  Did("file.open", {{"path", lacks_suffix ? WithProjectSuffix(path) : path}}, editor);
}

void SaveProject(Editor* editor) {
  FileDialogState& files = editor->dialogs.files;
  const std::string path = WithProjectSuffix(ChosenPath(files));
  const edit::Document& document = editor->session().document();
  const bool is_own = path == document.path() && !document.is_changed_elsewhere();
  std::error_code unknown;
  if (!files.asks_overwrite && std::filesystem::exists(path, unknown) && !is_own) {
    files.asks_overwrite = true;
    return;
  }
  files.asks_overwrite = false;
  const Then then = files.then;
  if (!Did("file.save", {{"path", path}, {"overwrite", true}}, editor)) return;
  editor->Say(Tr("Saved."));
  DoThen(then, editor);
}

// As the project's file will find it.
void TakeMedia(const char* id, Editor* editor) {
  const std::string& project = editor->session().document().path();
  std::filesystem::path path = ChosenPath(editor->dialogs.files);
  if (!project.empty()) {
    path = path.lexically_relative(
        std::filesystem::absolute(project).lexically_normal().parent_path());
  }
  Did(id, {{"file", path.string()}}, editor);
}

void TakeSound(Editor* editor) { TakeMedia("audio.set", editor); }
void TakeReference(Editor* editor) { TakeMedia("reference.set", editor); }

void TakeMesh(Editor* editor) {
  Did("file.add_mesh", {{"path", ChosenPath(editor->dialogs.files)}}, editor);
}

void TakeSweep(Editor* editor) {
  Did("sweep.open", {{"path", ChosenPath(editor->dialogs.files)}}, editor);
}

bool IsSweep(const std::string& path) {
  return std::filesystem::path(path).filename() == "sweep.csv";
}

void TakeFolder(Editor* editor) {
  const FileDialogState& files = editor->dialogs.files;
  editor->dialogs.render.folder = files.name.empty() ? files.folder : ChosenPath(files);
  Open(Modal::kRender, editor);
}

// The export dialog asks before it overwrites.
void TakeExport(Editor* editor) {
  editor->dialogs.exporting.path = ChosenPath(editor->dialogs.files);
  TakeTypedPath(&editor->dialogs.exporting);
  Open(Modal::kExport, editor);
}

void TakeOntoFile(Editor* editor) {
  editor->dialogs.exporting.onto = ChosenPath(editor->dialogs.files);
  TakeOnto(&editor->dialogs.exporting);
  Open(Modal::kExport, editor);
}

bool IsOntoFile(const std::string& path) { return CanBeOnto(path); }

}  // namespace

const FilePurpose kOpenProject = {.title = "Open project",
                                  .nothing = "There is no project in this folder.",
                                  .button = "Open",
                                  .button_help = "Opens the project, or the folder.",
                                  .wanted = IsProject,
                                  .take = OpenProject};
const FilePurpose kSaveProject = {.title = "Save project",
                                  .nothing = "There is no project in this folder.",
                                  .button = "Save",
                                  .button_help = "Saves under this name.",
                                  .wanted = IsProject,
                                  .take = SaveProject,
                                  .writes = true};
const FilePurpose kImportCharacter = {.title = "Import character",
                                      .nothing = "There is no character in this folder.",
                                      .button = "Open",
                                      .button_help = "Opens the character, or the folder.",
                                      .wanted = IsOfOtherProgram,
                                      .take = Import};
const FilePurpose kChooseSound = {.title = "Choose sound",
                                  .nothing = "There is no sound in this folder.",
                                  .button = "Choose",
                                  .button_help = "This is heard with the motion.",
                                  .wanted = IsSound,
                                  .take = TakeSound};
const FilePurpose kChooseReference = {.title = "Choose reference",
                                      .nothing = "There is no picture in this folder.",
                                      .button = "Choose",
                                      .button_help = "This is seen behind or in the scene.",
                                      .wanted = IsReference,
                                      .take = TakeReference};
const FilePurpose kChooseMesh = {.title = "Add mesh",
                                 .nothing = "There is no mesh in this folder.",
                                 .button = "Choose",
                                 .button_help = "This is put into the hand, or on the ground.",
                                 .wanted = IsMesh,
                                 .take = TakeMesh};
const FilePurpose kChooseSweep = {.title = "Open sweep",
                                  .nothing = "There is no sweep in this folder.",
                                  .button = "Open",
                                  .button_help = "Shows the cells of the sweep.",
                                  .wanted = IsSweep,
                                  .take = TakeSweep,
                                  .advice =
                                      "Choose sweep.csv in the folder that hazumi --sweep "
                                      "has filled."};
const FilePurpose kChooseFolder = {.title = "Choose folder",
                                   .nothing = "There is no folder in here.",
                                   .button = "Choose",
                                   .button_help = "The pictures go into this folder.",
                                   .wanted = nullptr,
                                   .take = TakeFolder,
                                   .back = Modal::kRender};
const FilePurpose kChooseExport = {.title = "Export",
                                   .nothing = "There is no such file in this folder.",
                                   .button = "Choose",
                                   .button_help = "The export goes into this file.",
                                   .wanted = IsExport,
                                   .take = TakeExport,
                                   .writes = true,
                                   .back = Modal::kExport};
const FilePurpose kChooseOnto = {.title = "Imported from",
                                 .nothing = "There is no such file in this folder.",
                                 .button = "Choose",
                                 .button_help = "The motion is put into a copy of this file.",
                                 .wanted = IsOntoFile,
                                 .take = TakeOntoFile,
                                 .back = Modal::kExport};

const std::vector<const FilePurpose*>& AllFilePurposes() {
  static const std::vector<const FilePurpose*> all = {
      &kOpenProject, &kSaveProject, &kImportCharacter, &kChooseSound,  &kChooseReference,
      &kChooseMesh,  &kChooseSweep, &kChooseFolder,    &kChooseExport, &kChooseOnto};
  return all;
}

}  // namespace hazumi::ui
