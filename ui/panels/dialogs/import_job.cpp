#include "ui/panels/dialogs/import_job.h"

#include <algorithm>

#include "engine/base/memory.h"
#include "engine/exchange/import/import_project.h"
#include "engine/exchange/read_character.h"
#include "ui/edit/operators/foreign_files.h"
#include "ui/panels/dialogs/dialogs.h"

namespace hazumi::ui {

ImportJob::ImportJob(std::string path, const ImportOptions& how)
    : path_(std::move(path)),
      character_name_(how.character),
      rate_(how.fps.value_or(0.0)),
      thread_([this] {
        ReadOptions options;
        options.character = character_name_;
        options.rate = rate_;
        options.is_cancelled = [this] { return cancel_.load(); };
        character_ = WithinMemory([&] { return ReadCharacter(path_, options); });
        has_ended_ = true;
      }) {}

ImportJob::~ImportJob() {
  cancel_ = true;
  thread_.join();
}

static void ReadAgain(ImportState* state) {
  state->imported.reset();
  state->job = std::make_shared<ImportJob>(state->job->path(), state->options);
}

void ChooseCharacter(const std::string& name, ImportState* state) {
  state->options.character = name;
  state->options.clip.clear();
  state->options.roles.clear();
  state->bone = -1;
  ReadAgain(state);
}

void ChooseRate(ImportState* state) {
  if (state->fps > 0.0) state->fps = std::clamp(state->fps, kLeastImportFps, kMostImportFps);
  state->options.fps = state->fps > 0.0 ? std::optional<double>(state->fps) : std::nullopt;
  ReadAgain(state);
}

void OpenImport(const std::string& path, Editor* editor) {
  ImportState& state = editor->dialogs.import;
  state = {};
  state.job = std::make_shared<ImportJob>(path, ImportOptions());
  editor->NeedGlyphs(path);
  Open(Modal::kImport, editor);
}

void RefreshImport(ImportState* state) {
  const Result<Character>* character = state->job->character();
  if (!character) return;
  if (!character->ok()) {
    state->imported = character->error();
    return;
  }
  ImportOptions& options = state->options;
  // The dialog shows which clip that is, and the others.
  const std::vector<Clip>& clips = character->value().clips;
  if (options.clip.empty() && !clips.empty()) options.clip = clips.front().name;
  const auto if_given = [](double value) {
    return value > 0.0 ? std::optional<double>(value) : std::nullopt;
  };
  options.height_m = if_given(state->height_m);
  options.mass_kg = if_given(state->mass_kg);
  options.reduce_deg = state->reduces ? if_given(state->reduce_deg) : std::nullopt;
  state->imported = ImportProject(character->value(), options);
}

void FinishImport(Editor* editor) {
  ImportState& state = editor->dialogs.import;
  if (!state.imported || !state.imported->ok()) return;
  edit::TakeImported(std::move(*state.imported).value(), &editor->session());
  editor->dialogs.imported = {editor->session().document_number(), state.job->path()};
  state = {};
  Close(editor);
  editor->Do("view.frame_all");
  editor->Say(Tr("Imported; not saved yet."));
}

}  // namespace hazumi::ui
