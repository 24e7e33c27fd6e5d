#include "ui/panels/dialogs/render_job.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "engine/base/filled.h"
#include "engine/base/memory.h"
#include "engine/project/project_files.h"
#include "ui/edit/media_files.h"
#include "ui/panels/dialogs/dialogs.h"
#include "ui/panels/viewport/scene.h"

namespace hazumi::ui {

namespace {

render::Camera CameraFor(const Editor& editor, bool through_project_camera) {
  const std::optional<ProjectCamera>& own = editor.session().project().camera;
  if (!through_project_camera || !own) return CameraOf(editor.viewport.camera);
  render::Camera camera;
  camera.eye = own->eye_m;
  camera.target = own->target_m;
  camera.vertical_fov_deg = own->vertical_fov_deg;
  return camera;
}

render::Overlays OverlaysFor(const Editor& editor) {
  render::Overlays overlays;
  const ViewportOverlays& seen = editor.viewport.overlays;
  overlays.look = LookOf(seen);
  const int frames = editor.last_frame() - editor.first_frame() + 1;
  overlays.ghosts =
      render::EveryNth(seen.ghosts ? seen.ghost_every : 0, static_cast<size_t>(frames));
  overlays.keyed_ghost = seen.keyed;
  overlays.paths = seen.paths;
  overlays.contact_marks = seen.marks;
  overlays.region_tint = seen.tint;
  return overlays;
}

// A range stays from one opening to the next, unless the frames it is of are others.
void TakeRange(const edit::Session& session, RenderState* render) {
  const ProjectFrames& frames = session.project().frames;
  const long document = session.document_number();
  if (render->document == document && render->document_frames == frames) return;
  render->document = document;
  render->document_frames = frames;
  render->first = frames.first;
  render->last = frames.last;
}

}  // namespace

std::string FileNameFrom(std::string name) {
  for (char& c : name) {
    if (c == '/' || c == ' ' || static_cast<unsigned char>(c) < 0x20) c = '_';
  }
  return name.empty() ? "picture" : name;
}

std::string ProjectNameOf(const Editor& editor) {
  const edit::Session& session = editor.session();
  return ShownName(session.project().name, session.document().path());
}

std::string SizeTrouble(int width, int height) {
  constexpr int kLargest = 8192;  // [px]
  const auto [low, high] = std::minmax(width, height);
  const bool is_wrong = low < 1 || high > kLargest;
  return is_wrong ? Tr("Width and height must be from 1 to 8192.") : "";
}

std::string RangeTrouble(int first, int last, const ProjectFrames& frames) {
  if (first > last) return Tr("The first frame must not come after the last one.");
  if (first >= frames.first && last <= frames.last) return "";
  return Filled(Tr("The animation has the frames from %d to %d."), frames.first, frames.last);
}

std::string PictureName(const RenderTask& task, int frame) {
  char number[16];
  std::snprintf(number, sizeof number, "%s%04d", frame < 0 ? "-" : "", std::abs(frame));
  const std::string name = FileNameFrom(task.project) + "_" + number + ".png";
  return (std::filesystem::path(task.folder) / name).string();
}

RenderTask OutlineOf(const Editor& editor) {
  const RenderState& render = editor.dialogs.render;
  const edit::Session& session = editor.session();
  RenderTask task;
  task.width = render.width;
  task.height = render.height;
  const ProjectFrames& frames = session.project().frames;
  const int now = static_cast<int>(std::lround(session.frame()));
  task.first = render.whole ? render.first : std::clamp(now, frames.first, frames.last);
  task.last = render.whole ? render.last : task.first;
  task.folder = PathOf(HomeFolder(), render.folder, HomeFolder());
  task.project = ProjectNameOf(editor);
  return task;
}

std::string SummaryOf(const RenderTask& task) {
  const long count = std::max(0L, static_cast<long>(task.last) - task.first + 1);
  const std::string size = std::to_string(task.width) + " x " + std::to_string(task.height);
  const std::string first = NameIn(PictureName(task, task.first));
  const std::string last = NameIn(PictureName(task, task.last));
  const std::string number = count == 1 ? Tr("1 picture") : std::to_string(count) + Tr(" pictures");
  const std::string names = count == 1 ? first : first + " - " + last;
  return number + ", " + size + ", " + names + Tr(", into ") + task.folder;
}

int CountExisting(const RenderTask& task) {
  int count = 0;
  std::error_code unknown;
  constexpr long kMost = 100'000;  // of a range that was typed and is no animation's
  const bool is_range = static_cast<long>(task.last) - task.first < kMost;
  if (!is_range || !std::filesystem::is_directory(task.folder, unknown)) return 0;
  for (int frame = task.first; frame <= task.last; ++frame) {
    count += std::filesystem::exists(PictureName(task, frame), unknown) ? 1 : 0;
  }
  return count;
}

RenderJob::RenderJob(RenderTask task, PictureWriter writer)
    : task_(std::move(task)), thread_([this, writer = std::move(writer)] {
        result_ = WithinMemory([&] {
          return writer(
              task_, [this](int written) { written_ = written; }, &cancel_);
        });
        has_ended_ = true;
      }) {}

RenderJob::~RenderJob() {
  cancel_ = true;
  thread_.join();
}

std::optional<Result<int>> RenderJob::result() const { return has_ended_ ? result_ : std::nullopt; }

void OpenRenderDialog(Editor* editor, bool whole) {
  RenderState& render = editor->dialogs.render;
  render.whole = whole;
  render.error.clear();
  render.counted.clear();
  TakeRange(editor->session(), &render);
  if (render.folder.empty()) {
    const std::string& path = editor->session().document().path();
    const std::string folder =
        path.empty() ? HomeFolder() : ParentOf(std::filesystem::absolute(path).string());
    render.folder = (std::filesystem::path(folder) / "render").string();
    render.through_project_camera = editor->viewport.through_project_camera;
  }
  Open(Modal::kRender, editor);
}

Result<RenderTask> FilledTask(Editor* editor, RenderTask task, bool through_project_camera,
                              bool overlays) {
  edit::Session& session = editor->session();
  const Result<const Motion*> motion = session.WholeMotion();
  if (!motion.ok()) return motion.error();
  task.animation = *session.animation();
  task.motion = *motion.value();
  task.skin = session.project().skin;
  task.reference = edit::RenderedReference(session.project());
  const std::string& path = session.document().path();
  if (auto closed = edit::WhyClosedToPictures(session.project(), path, session.media()))
    return *closed;
  task.reference_path = ReferencePath(session.project(), path);
  task.reference_rate = {session.project().fps.num, session.project().fps.den};
  task.overlays.look = LookOf(editor->viewport.overlays);
  task.camera = CameraFor(*editor, through_project_camera);
  if (overlays) task.overlays = OverlaysFor(*editor);
  return task;
}

void StartJob(RenderTask task, Editor* editor) {
  RenderState& render = editor->dialogs.render;
  render.job = std::make_shared<RenderJob>(std::move(task), editor->write_pictures);
  Open(Modal::kProgress, editor);
}

void StartRender(Editor* editor) {
  RenderState& render = editor->dialogs.render;
  const RenderTask outline = OutlineOf(*editor);
  render.error = SizeTrouble(outline.width, outline.height);
  if (render.error.empty()) {
    render.error = RangeTrouble(outline.first, outline.last, editor->session().project().frames);
  }
  if (!render.error.empty()) return;
  Result<RenderTask> task =
      FilledTask(editor, outline, render.through_project_camera, render.overlays);
  if (!task.ok()) {
    render.error = task.error().ToString();
    return;
  }
  StartJob(std::move(task).value(), editor);
}

}  // namespace hazumi::ui
