#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "ui/edit/operators/foreign_files.h"
#include "ui/panels/dialogs/background_task.h"
#include "ui/panels/dialogs/export_summary.h"
#include "ui/panels/dialogs/render_job.h"

namespace hazumi::ui {

// A file as it will be written, and what is in it.
struct ExportedFile {
  std::string bytes;
  ExportSummary summary;
};

enum class ExportRange { kAll, kPreview, kFromTo };

// The export dialog: what is written, where, and how far that is. Stays between openings.
struct ExportState {
  bool is_video = false;          // MP4, else what `settings` says
  edit::ExportSettings settings;  // but for its frames
  ExportRange range = ExportRange::kAll;
  int first = 0, last = 0;  // of kFromTo
  std::string path;
  bool is_onto = false;  // into the file that the figure was imported from, `onto`
  std::string onto;
  int width = 1280, height = 720;  // of videos [px], as is what follows
  bool through_project_camera = false;
  bool overlays = false;
  std::string error;

  long document = -1;  // that this is about

  // What the preview is made of, and of which state of the document.
  std::shared_ptr<const edit::ExportSource> source;
  std::pair<long, long> source_state = {-1, -1};  // document and revision
  std::optional<Error> source_error;              // kInterrupted: it is being computed
  // The file with `previewed`; the last one is kept until there is another.
  std::shared_ptr<BackgroundTask<ExportedFile>> preview;
  edit::ExportSettings previewed;
  std::shared_ptr<const edit::ExportSource> previewed_source;

  bool asks_overwrite = false;
  bool wants_write = false;  // as soon as the preview is what the options say
  std::shared_ptr<BackgroundTask<Done>> write;
  std::shared_ptr<std::atomic<bool>> cancels_write;
  std::string written_path;
  size_t written_bytes = 0;
};

// The settings with the frames of the range.
edit::ExportSettings ExportSettingsOf(const Editor& editor);
// The file that is written: the typed path with the format's suffix.
std::string ExportPath(const ExportState& state);
std::string SuffixOf(const ExportState& state);
// Chooses a format; the path follows it. None: MP4.
void ChooseFormat(std::optional<MotionFormat> format, ExportState* state);
// A suffix that was typed chooses the format; one that is missing is put there.
void TakeTypedPath(ExportState* state);
// Whether the motion can be put into a file, and shall be.
bool MayBeOnto(const Editor& editor);
bool IsOnto(const Editor& editor);
// A file to put the motion into was named: what is written is of its format.
void TakeOnto(ExportState* state);
// "MotionFormat::kGlb" etc. have meshes.
bool HasMeshes(const ExportState& state);

// The preview as the options are now; null while it is being made or cannot be.
const Result<ExportedFile>* CurrentPreview(const Editor& editor);
// What cannot be written as the options are, in the interface's language; empty: nothing.
std::string ExportTrouble(const Editor& editor);
// Goes on with what is under way: begins the preview that the options ask for, writes what is
// wanted, and ends the dialog after it. Once a frame.
void RefreshExport(Editor* editor);
// Gives up writing; the dialog stays.
void CancelExport(ExportState* state);

}  // namespace hazumi::ui
