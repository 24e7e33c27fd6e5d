#include "ui/panels/render_job.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "ui/panels/dialogs.h"

namespace hazumi::ui {

namespace {

// Of a project's name, what a file's name may have.
std::string FileNameFrom(std::string name) {
  for (char& c : name) {
    if (c == '/' || c == ' ' || static_cast<unsigned char>(c) < 0x20) c = '_';
  }
  return name.empty() ? "picture" : name;
}

render::Camera CameraFor(const Editor& editor) {
  const std::optional<ProjectCamera>& own = editor.session().project().camera;
  if (!editor.dialogs.render.through_project_camera || !own) {
    return CameraOf(editor.viewport.camera);
  }
  render::Camera camera;
  camera.eye = own->eye_m;
  camera.target = own->target_m;
  camera.vertical_fov_deg = own->vertical_fov_deg;
  return camera;
}

render::Overlays OverlaysFor(const Editor& editor) {
  render::Overlays overlays;
  if (!editor.dialogs.render.overlays) return overlays;
  const ViewportOverlays& seen = editor.viewport.overlays;
  overlays.ghost_every = seen.ghosts ? seen.ghost_every : 0;
  overlays.paths = seen.paths;
  overlays.contact_marks = seen.marks;
  overlays.region_tint = seen.tint;
  return overlays;
}

Result<RenderTask> TaskFor(Editor* editor) {
  const RenderState& render = editor->dialogs.render;
  edit::Session& session = editor->session();
  const Result<const Motion*> motion = session.WholeMotion();
  if (!motion.ok()) return motion.error();
  RenderTask task;
  task.animation = *session.animation();
  task.motion = *motion.value();
  task.camera = CameraFor(*editor);
  task.overlays = OverlaysFor(*editor);
  task.width = render.width;
  task.height = render.height;
  const ProjectFrames& frames = session.project().frames;
  const int now = static_cast<int>(std::lround(session.frame()));
  task.first = render.whole ? frames.first : std::clamp(now, frames.first, frames.last);
  task.last = render.whole ? frames.last : task.first;
  task.folder = PathOf(HomeFolder(), render.folder, HomeFolder());
  task.project = session.project().name;
  return task;
}

}  // namespace

std::string PictureName(const RenderTask& task, int frame) {
  char number[16];
  std::snprintf(number, sizeof number, "%s%04d", frame < 0 ? "-" : "", std::abs(frame));
  const std::string name = FileNameFrom(task.project) + "_" + number + ".png";
  return (std::filesystem::path(task.folder) / name).string();
}

RenderJob::RenderJob(RenderTask task, PictureWriter writer)
    : task_(std::move(task)), thread_([this, writer = std::move(writer)] {
        result_ = writer(
            task_, [this](int written) { written_ = written; }, &cancel_);
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
  if (render.folder.empty()) {
    const std::string& path = editor->session().document().path();
    const std::string folder =
        path.empty() ? HomeFolder() : ParentOf(std::filesystem::absolute(path).string());
    render.folder = (std::filesystem::path(folder) / "render").string();
    render.through_project_camera = editor->viewport.through_project_camera;
  }
  Open(Modal::kRender, editor);
}

void StartRender(Editor* editor) {
  RenderState& render = editor->dialogs.render;
  constexpr int kLargest = 8192;  // [px]
  if (std::min(render.width, render.height) < 1 ||
      std::max(render.width, render.height) > kLargest) {
    render.error = Tr("Width and height must be from 1 to 8192.");
    return;
  }
  Result<RenderTask> task = TaskFor(editor);
  if (!task.ok()) {
    render.error = task.error().ToString();
    return;
  }
  render.error.clear();
  render.job = std::make_shared<RenderJob>(std::move(task).value(), editor->write_pictures);
  Open(Modal::kProgress, editor);
}

}  // namespace hazumi::ui
