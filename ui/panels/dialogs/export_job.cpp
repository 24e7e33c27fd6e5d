#include "ui/panels/dialogs/export_job.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "engine/base/atomic_file.h"
#include "engine/base/text.h"
#include "ui/edit/media_files.h"
#include "ui/panels/dialogs/dialogs.h"

namespace hazumi::ui {

namespace fs = std::filesystem;

namespace {

bool IsVideoName(const std::string& path) { return LowerCase(path).ends_with(".mp4"); }

// Beside the project's file and named as it is, or else at home.
std::string FirstPath(const Editor& editor) {
  const std::string& project = editor.session().document().path();
  if (!project.empty()) return fs::absolute(project).replace_extension().string();
  return (fs::path(HomeFolder()) / FileNameFrom(ProjectNameOf(editor))).string();
}

std::pair<long, long> StateNow(const Editor& editor) {
  const edit::Session& session = editor.session();
  return {session.document_number(), session.document().revision()};
}

bool IsCurrent(const ExportState& state, const Editor& editor) {
  return state.source && state.preview && state.previewed_source == state.source &&
         state.source_state == StateNow(editor) && state.previewed == ExportSettingsOf(editor);
}

// The motion as the document is, once it is there.
void RefreshSource(Editor* editor) {
  ExportState& state = editor->dialogs.exporting;
  state.source_error.reset();
  if (state.source && state.source_state == StateNow(*editor)) return;
  Result<edit::ExportSource> source = edit::ExportSourceOf(&editor->session());
  if (!source.ok()) {
    state.source_error = source.error();
    return;
  }
  state.source = std::make_shared<const edit::ExportSource>(std::move(source).value());
  state.source_state = StateNow(*editor);
}

Result<ExportedFile> ExportedOnto(const edit::ExportSource& source,
                                  const edit::ExportSettings& settings) {
  Result<OntoFile> file = edit::OntoFileOf(source, settings);
  if (!file.ok()) return file.error();
  ExportSummary summary;
  summary.num_bytes = file.value().bytes.size();
  summary.joints = static_cast<int>(file.value().bones.size());
  for (const std::string& bone : file.value().bones) summary.head += bone + "\n";
  return ExportedFile{std::move(file.value().bytes), std::move(summary)};
}

// The file that the figure was imported from: as it was, or beside the project's file.
std::string FirstOnto(const Editor& editor) {
  const std::optional<ProjectSource>& source = editor.session().project().source;
  if (!source) return "";
  const auto& [document, path] = editor.dialogs.imported;
  if (document == editor.session().document_number() && !path.empty()) return path;
  return (fs::path(FirstPath(editor)).parent_path() / source->file).string();
}

// Nothing proposes to write over the file that the figure was imported from.
void KeepSource(const Editor& editor, ExportState* state) {
  const auto& source = editor.session().project().source;
  fs::path path = state->path;
  if (!source || path.filename() != source->file) return;
  path.replace_filename(path.stem().string() + "_new" + path.extension().string());
  state->path = path.string();
}

void StartPreview(Editor* editor) {
  ExportState& state = editor->dialogs.exporting;
  const bool is_busy = state.preview && !state.preview->result();
  if (is_busy || state.source_error || IsCurrent(state, *editor)) return;
  state.previewed = ExportSettingsOf(*editor);
  state.previewed_source = state.source;
  const auto make = [source = state.source, settings = state.previewed]() -> Result<ExportedFile> {
    if (!settings.onto.empty()) return ExportedOnto(*source, settings);
    Result<std::string> bytes = edit::BytesOf(*source, settings);
    if (!bytes.ok()) return bytes.error();
    ExportSummary summary = SummaryOf(settings.format, bytes.value());
    return ExportedFile{std::move(bytes).value(), std::move(summary)};
  };
  state.preview = std::make_shared<BackgroundTask<ExportedFile>>(make);
}

void StartWrite(Editor* editor) {
  ExportState& state = editor->dialogs.exporting;
  const Result<ExportedFile>* file = CurrentPreview(*editor);
  if (state.write || (!file && !state.source_error)) return;
  const bool waits = state.source_error && state.source_error->code == ErrorCode::kInterrupted;
  if (waits && editor->session().bake() && editor->session().bake()->is_busy()) return;
  if (!file || !file->ok()) {
    state.wants_write = false;
    state.error = (file ? file->error() : *state.source_error).ToString();
    return;
  }
  state.cancels_write = std::make_shared<std::atomic<bool>>(false);
  state.written_path = ExportPath(state);
  state.written_bytes = file->value().bytes.size();
  const auto write = [preview = state.preview, path = state.written_path,
                      cancel = state.cancels_write] {
    const std::string& bytes = preview->result()->value().bytes;
    return WriteFileAtomically(path, bytes, WriteMode::kDurable, cancel.get());
  };
  state.write = std::make_shared<BackgroundTask<Done>>(write);
}

void FinishWrite(Editor* editor) {
  ExportState& state = editor->dialogs.exporting;
  const Result<Done>* done = state.write ? state.write->result() : nullptr;
  if (!done) return;
  const bool was_awaited = std::exchange(state.wants_write, false);
  if (done->ok()) {
    editor->Say(Tr("Exported: ") + state.written_path + " (" + SizeText(state.written_bytes) + ")");
    if (was_awaited && editor->dialogs.modal == Modal::kExport) CloseExport(editor);
  } else if (done->error().code != ErrorCode::kInterrupted) {
    state.error = done->error().ToString();
  }
  state.write.reset();
}

Result<RenderTask> VideoTask(Editor* editor) {
  const ExportState& state = editor->dialogs.exporting;
  RenderTask task;
  const edit::ExportSettings settings = ExportSettingsOf(*editor);
  task.width = state.width;
  task.height = state.height;
  task.first = settings.first;
  task.last = settings.last;
  task.video = ExportPath(state);
  task.project = ProjectNameOf(*editor);
  const edit::Session& session = editor->session();
  const FrameRate rate{session.project().fps.num, session.project().fps.den};
  const std::string& path = session.document().path();
  const auto sound = edit::HeardIn(session.project(), path, rate.SecondsAt(task.first),
                                   rate.SecondsAt(task.last - task.first + 1), session.media());
  if (!sound.ok()) return sound.error();
  task.sound = sound.value();
  return FilledTask(editor, std::move(task), state.through_project_camera, state.overlays);
}

// What has been made for the preview, which is large.
void DropFile(ExportState* state) {
  state->source.reset();
  state->previewed_source.reset();
  if (state->preview && state->preview->result()) state->preview.reset();
}

bool NamesAFile(const ExportState& state) {
  if (state.path.empty() || fs::path(state.path).filename().empty()) return false;
  std::error_code unknown;
  return !fs::is_directory(PathOf(HomeFolder(), state.path, HomeFolder()), unknown);
}

void StartVideo(Editor* editor) {
  ExportState& state = editor->dialogs.exporting;
  Result<RenderTask> task = VideoTask(editor);
  if (!task.ok()) {
    state.error = task.error().ToString();
    return;
  }
  DropFile(&state);
  StartJob(std::move(task).value(), editor);
}

}  // namespace

edit::ExportSettings ExportSettingsOf(const Editor& editor) {
  const ExportState& state = editor.dialogs.exporting;
  const Project& project = editor.session().project();
  edit::ExportSettings settings = state.settings;
  ProjectFrames frames = project.frames;
  if (state.range == ExportRange::kPreview && project.preview) frames = *project.preview;
  const bool is_own = state.range == ExportRange::kFromTo;
  settings.first = is_own ? state.first : std::max(frames.first, project.frames.first);
  settings.last = is_own ? state.last : std::min(frames.last, project.frames.last);
  if (IsOnto(editor)) {
    settings.onto = PathOf(HomeFolder(), state.onto, HomeFolder());
    settings.path = ExportPath(state);
  }
  return settings;
}

bool MayBeOnto(const Editor& editor) {
  const ExportState& state = editor.dialogs.exporting;
  return editor.session().project().source && !state.is_video &&
         CanBeOnto("name" + SuffixOf(state));
}

bool IsOnto(const Editor& editor) { return editor.dialogs.exporting.is_onto && MayBeOnto(editor); }

void TakeOnto(ExportState* state) {
  if (!CanBeOnto(state->onto)) return;
  fs::path path = state->path;
  path.replace_extension(fs::path(state->onto).extension());
  // The file itself is kept.
  if (path == state->onto)
    path.replace_filename(path.stem().string() + "_new" + path.extension().string());
  state->path = path.string();
  state->settings.format = MotionFormatOf(state->onto).value_or(MotionFormat::kGlb);
  state->error.clear();
}

std::string SuffixOf(const ExportState& state) {
  if (state.is_video) return ".mp4";
  if (state.is_onto && CanBeOnto(state.onto))
    return LowerCase(fs::path(state.onto).extension().string());
  switch (state.settings.format) {
    case MotionFormat::kBvh:
      return ".bvh";
    case MotionFormat::kGltf:
      return ".gltf";
    case MotionFormat::kGlb:
      return ".glb";
    case MotionFormat::kCsv:
      return ".csv";
    case MotionFormat::kJson:
      break;
  }
  return ".json";
}

std::string ExportPath(const ExportState& state) {
  const std::string path = PathOf(HomeFolder(), state.path, HomeFolder());
  return LowerCase(path).ends_with(SuffixOf(state)) ? path : path + SuffixOf(state);
}

bool HasMeshes(const ExportState& state) {
  const MotionFormat format = state.settings.format;
  return !state.is_video && (format == MotionFormat::kGltf || format == MotionFormat::kGlb);
}

void ChooseFormat(std::optional<MotionFormat> format, ExportState* state) {
  fs::path path = state->path;
  const bool has_suffix = MotionFormatOf(state->path) || IsVideoName(state->path);
  if (has_suffix) path.replace_extension();
  state->is_video = !format;
  if (format) state->settings.format = *format;
  if (!format || format != MotionFormatOf(state->onto)) state->is_onto = false;
  state->path = path.empty() ? "" : path.string() + SuffixOf(*state);
  state->error.clear();
}

void TakeTypedPath(ExportState* state) {
  const std::optional<MotionFormat> format = MotionFormatOf(state->path);
  if (format || IsVideoName(state->path)) {
    ChooseFormat(format, state);
  } else if (NamesAFile(*state)) {
    state->path += SuffixOf(*state);
  }
}

const Result<ExportedFile>* CurrentPreview(const Editor& editor) {
  const ExportState& state = editor.dialogs.exporting;
  return IsCurrent(state, editor) ? state.preview->result() : nullptr;
}

std::string ExportTrouble(const Editor& editor) {
  const ExportState& state = editor.dialogs.exporting;
  const edit::ExportSettings settings = ExportSettingsOf(editor);
  const ProjectFrames& frames = editor.session().project().frames;
  std::string trouble = RangeTrouble(settings.first, settings.last, frames);
  if (!trouble.empty()) return trouble;
  const bool is_odd = state.width % 2 != 0 || state.height % 2 != 0;
  if (state.is_video && is_odd) return Tr("Videos have even sizes: add a pixel.");
  return state.is_video ? SizeTrouble(state.width, state.height) : "";
}

void OpenExportDialog(Editor* editor) {
  ExportState& state = editor->dialogs.exporting;
  const long document = editor->session().document_number();
  state.error.clear();
  state.asks_overwrite = state.wants_write = false;
  if (state.document != document || state.path.empty()) {
    state.settings = edit::UsualSettings(editor->session(), state.settings.format);
    state.range = ExportRange::kAll;
    state.first = state.settings.first;
    state.last = state.settings.last;
    state.path = FirstPath(*editor) + SuffixOf(state);
    KeepSource(*editor, &state);
    state.through_project_camera = editor->viewport.through_project_camera;
    state.document = document;
    state.is_onto = false;
    state.onto = FirstOnto(*editor);
    state.source.reset();
  }
  editor->NeedGlyphs(state.path);
  Open(Modal::kExport, editor);
}

void CloseExport(Editor* editor) {
  ExportState& state = editor->dialogs.exporting;
  CancelExport(&state);
  DropFile(&state);
  Close(editor);
}

void StartExport(Editor* editor) {
  ExportState& state = editor->dialogs.exporting;
  TakeTypedPath(&state);
  state.error = ExportTrouble(*editor);
  if (!NamesAFile(state)) state.error = Tr("Name a file to write.");
  if (!state.error.empty()) return;
  if (const auto error = edit::CheckPlace(ExportPath(state))) {
    state.error = error->ToString();
    return;
  }
  std::error_code unknown;
  state.asks_overwrite = fs::exists(ExportPath(state), unknown);
  if (!state.asks_overwrite) ConfirmExport(editor);
}

void ConfirmExport(Editor* editor) {
  ExportState& state = editor->dialogs.exporting;
  state.asks_overwrite = false;
  if (state.is_video) return StartVideo(editor);
  state.wants_write = true;
}

void CancelExport(ExportState* state) {
  state->wants_write = false;
  if (state->write) *state->cancels_write = true;
}

void RefreshExport(Editor* editor) {
  ExportState& state = editor->dialogs.exporting;
  FinishWrite(editor);
  const bool is_over = editor->dialogs.modal != Modal::kExport;
  if (is_over && !state.write) DropFile(&state);
  if (is_over || state.is_video || !ExportTrouble(*editor).empty()) return;
  RefreshSource(editor);
  StartPreview(editor);
  if (state.wants_write) StartWrite(editor);
}

}  // namespace hazumi::ui
