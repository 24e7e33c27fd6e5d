// Which dialog is open, what follows from its answers, and the actions that open them.

#include "ui/panels/dialogs/dialogs.h"

#include <algorithm>
#include <filesystem>

#include "ui/edit/operator.h"

namespace hazumi::ui {

namespace {

using enum edit::ParameterKind;
using edit::Parameters;

Result<Done> New(Editor* editor, const Parameters&) {
  return AskToSave(editor, [](Editor* asked) { return asked->Invoke("file.new"); });
}

Result<Done> OpenPath(Editor* editor, const Parameters& p) {
  const std::string path = p.text("path");
  return AskToSave(editor, [path](Editor* asked) -> Result<Done> {
    asked->message = {};
    if (IsOfOtherProgram(path)) {
      OpenImport(path, asked);
      return Done();
    }
    return asked->Invoke("file.open", {{"path", path}});
  });
}

using Run = std::function<Result<Done>(Editor*, const Parameters&)>;

Run FileDialogFor(const FilePurpose& purpose) {
  return [&purpose](Editor* editor, const Parameters&) -> Result<Done> {
    OpenFileDialog(editor, purpose);
    return Done();
  };
}

// What replaces the project.
Run FileDialogAfterSaving(const FilePurpose& purpose) {
  return [&purpose](Editor* editor, const Parameters&) {
    return AskToSave(editor, [&purpose](Editor* asked) -> Result<Done> {
      OpenFileDialog(asked, purpose);
      return Done();
    });
  };
}

Result<Done> Save(Editor* editor, const Parameters&) { return SaveThen(editor, nullptr); }

Result<Done> ShowFirstSteps(Editor* editor, const Parameters& p) {
  DialogsState& dialogs = editor->dialogs;
  dialogs.shows_first_steps = p.yes("on", !dialogs.shows_first_steps);
  if (dialogs.shows_first_steps && dialogs.first_steps.all()) dialogs.first_steps = {};
  if (!dialogs.shows_first_steps) editor->settings.has_seen_first_steps = true;
  return Done();
}

Run Opener(Modal modal) {
  return [modal](Editor* editor, const Parameters&) -> Result<Done> {
    Open(modal, editor);
    return Done();
  };
}

Result<Done> ShowSearch(Editor* editor, const Parameters&) {
  editor->dialogs.search = {};
  Open(Modal::kSearch, editor);
  return Done();
}

Result<Done> ShowForm(Editor* editor, const Parameters& p) {
  const std::string id = p.text("id");
  if (!FindAction(id) && !edit::FindOperator(id)) {
    return Error{ErrorCode::kSchema, "", "id", "there is no \"" + id + "\""};
  }
  editor->dialogs.form = MakeForm(id, Json::object(), &editor->session());
  Open(Modal::kForm, editor);
  return Done();
}

Result<Done> ExportWithDialog(Editor* editor, const Parameters& p) {
  OpenExportDialog(editor);
  ExportState& state = editor->dialogs.exporting;
  if (p.has("path")) state.path = p.text("path");
  TakeTypedPath(&state);
  return Done();
}

Result<Done> ShowRender(Editor* editor, const Parameters& p) {
  OpenRenderDialog(editor, p.yes("whole"));
  return Done();
}

}  // namespace

std::vector<Action> DialogActions() {
  return {
      {"app.new",
       "New",
       "A new project: the human, standing on the ground. Asks about unsaved changes.",
       {},
       New},
      {"app.open",
       "Open file",
       "Opens a project, or imports a character. Asks about unsaved changes.",
       {{"path", kText, true, "a .kfa file, or one of another program"}},
       OpenPath},
      {"file.open_dialog",
       "Open",
       "Chooses a project to open.",
       {},
       FileDialogAfterSaving(kOpenProject),
       true},
      {"file.import_dialog",
       "Import character",
       "Makes a project of a character and its clip: BVH, FBX, glTF, GLB or Collada.",
       {},
       FileDialogAfterSaving(kImportCharacter),
       true},
      {"file.sound_dialog",
       "Choose sound",
       "Chooses the sound that is heard with the motion: WAV, MP3, a video's, and others.",
       {},
       FileDialogFor(kChooseSound),
       true},
      {"file.reference_dialog",
       "Choose reference",
       "Chooses a picture or a video to animate by; it is seen behind or in the scene.",
       {},
       FileDialogFor(kChooseReference),
       true},
      {"file.mesh_dialog",
       "Choose mesh",
       "Puts a mesh of another program into the selected hand, or on the ground: glTF, GLB, FBX, "
       "Collada or OBJ.",
       {},
       FileDialogFor(kChooseMesh),
       true},
      {"file.sweep_dialog",
       "Open sweep",
       "Chooses a sweep: the table sweep.csv in the folder that hazumi --sweep has filled.",
       {},
       FileDialogFor(kChooseSweep),
       true},
      {"file.export_dialog",
       "Export",
       "Writes the motion for other programs: BVH, glTF, CSV, JSON, or a video.",
       {{"path", kText, false, "the file that is proposed; not given: as the time before"}},
       ExportWithDialog,
       true},
      {"app.save", "Save", "Saves the project; asks for a name if it has none.", {}, Save},
      {"file.save_as",
       "Save as",
       "Saves the project under another name.",
       {},
       FileDialogFor(kSaveProject),
       true},
      {"app.search",
       "Search",
       "Finds whatever Hazumi can do by its name, and does it.",
       {},
       ShowSearch},
      {"app.form",
       "Form",
       "Asks for the parameters of an action or operator, and does it.",
       {{"id", kText, true, "what is to be done, such as placement.set"}},
       ShowForm},
      {"help.manual", "Manual", "What a region is, and the keys.", {}, Opener(Modal::kManual)},
      {"app.preferences",
       "Preferences",
       "Language, theme, scale, and the keys of the keyboard.",
       {},
       Opener(Modal::kPreferences)},
      {"help.about", "About Hazumi", "Version and licence.", {}, Opener(Modal::kAbout)},
      {"help.first_steps",
       "First steps",
       "Five steps that lead to a throw.",
       {{"on", kYesNo, false, "not given: the other way round"}},
       ShowFirstSteps},
      {"render.dialog",
       "Render",
       "Draws pictures of the animation into PNG files.",
       {{"whole", kYesNo, false, "true: all frames, else the current one"}},
       ShowRender,
       true}};
}

void Open(Modal modal, Editor* editor) {
  editor->Take(nullptr);
  editor->dialogs.modal = modal;
  editor->dialogs.just_opened = true;
}

void Close(Editor* editor) { editor->dialogs.modal = Modal::kNone; }

Result<Done> AskToSave(Editor* editor, Then then) {
  if (editor->session().document().is_saved()) return then(editor);
  editor->dialogs.then = std::move(then);
  Open(Modal::kUnsaved, editor);
  return Done();
}

void AnswerSave(Editor* editor) {
  const Then then = editor->dialogs.then;
  Close(editor);
  (void)SaveThen(editor, then);
}

Result<Done> SaveThen(Editor* editor, Then then) {
  const edit::Document& document = editor->session().document();
  if (document.path().empty()) {
    OpenFileDialog(editor, kSaveProject, std::move(then));
    return Done();
  }
  if (document.is_changed_elsewhere()) {
    editor->dialogs.then = std::move(then);
    Open(Modal::kChangedElsewhere, editor);
    return Done();
  }
  Result<Done> saved = editor->Invoke("file.save");
  if (!saved.ok()) return saved;
  editor->Say(Tr("Saved."));
  DoThen(then, editor);
  return saved;
}

void AnswerKeepMine(Editor* editor) {
  const Then then = editor->dialogs.then;
  Close(editor);
  if (!editor->Do("file.save", {{"overwrite", true}})) return;
  editor->Say(Tr("Saved."));
  DoThen(then, editor);
}

void AnswerTakeTheirs(Editor* editor) {
  const Then then = editor->dialogs.then;
  const std::string path = editor->session().document().path();
  Close(editor);
  if (editor->Do("file.open", {{"path", path}})) DoThen(then, editor);
}

void AnswerSaveAs(Editor* editor) { OpenFileDialog(editor, kSaveProject, editor->dialogs.then); }

void AnswerDiscard(Editor* editor) {
  const Then then = editor->dialogs.then;
  Close(editor);
  DoThen(then, editor);
}

// Back to the pictures that are being drawn, if there are any.
void AnswerCancel(Editor* editor) {
  Close(editor);
  if (editor->dialogs.render.job) Open(Modal::kProgress, editor);
}

float MiddleOfDialog(float width, const Rect& window, const Rect& card) {
  const float middle = window.x + 0.5f * window.w;
  const bool is_clear = middle + 0.5f * width < card.x;
  return is_clear || card.x - window.x < width ? middle : 0.5f * (window.x + card.x);
}

Result<Done> RunOrAsk(Editor* editor, const std::string& id, const Json& parameters) {
  if (!NeedsForm(id, parameters)) return editor->Invoke(id, parameters);
  editor->dialogs.form = MakeForm(id, parameters, &editor->session());
  Open(Modal::kForm, editor);
  return Done();
}

void SubmitForm(Editor* editor) {
  FormState& form = editor->dialogs.form;
  const Result<Json> values = ValuesOf(form);
  Result<Done> done = Done();
  if (values.ok()) {
    done = editor->Invoke(form.id, values.value());
  } else {
    done = values.error();
  }
  if (!done.ok()) {
    form.error = TextOf(done.error(), form.id);
  } else if (editor->dialogs.modal == Modal::kForm) {
    Close(editor);
  }
}

void AddRecent(const std::string& path, Settings* settings) {
  constexpr size_t kMost = 10;
  if (path.empty()) return;
  const std::string whole = std::filesystem::absolute(path).lexically_normal().string();
  std::vector<std::string>& files = settings->recent_files;
  std::erase(files, whole);
  files.insert(files.begin(), whole);
  if (files.size() > kMost) files.resize(kMost);
}

}  // namespace hazumi::ui
