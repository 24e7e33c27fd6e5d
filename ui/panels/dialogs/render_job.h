#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "engine/bake/motion.h"
#include "engine/base/result.h"
#include "engine/media/sound_part.h"
#include "engine/project/project.h"
#include "engine/timeline/animation.h"
#include "render/motion/motion_scene.h"
#include "render/scene/camera.h"

namespace hazumi::ui {

class Editor;

// Pictures to be drawn into files, or into a video; all that is needed, so that the editor may go
// on meanwhile.
struct RenderTask {
  Animation animation;
  Motion motion;
  ProjectSkin skin;
  std::optional<ProjectReference> reference;  // if it is seen in pictures
  std::string reference_path;
  FrameRate reference_rate;  // of the project
  render::Camera camera;
  render::Overlays overlays;
  bool shadow = true;
  int width = 1280, height = 720;  // [px]
  int first = 0, last = 0;         // frames, both drawn
  std::string folder;              // made if it is not there
  std::string video;               // a file; not empty: an MP4 instead of pictures
  std::optional<SoundPart> sound;  // of the video
  std::string project;             // its name, for file names and the pictures' texts
};

// The file of a frame: "folder/throw_0007.png".
std::string PictureName(const RenderTask& task, int frame);

// Draws and writes a task's pictures; `written` is told how many there are so far. Returns their
// number; stops when `cancel` is set, which is no error. Nothing is left of a video that is not
// whole.
using PictureWriter =
    std::function<Result<int>(const RenderTask& task, const std::function<void(int)>& written,
                              const std::atomic<bool>* cancel)>;

// Writes pictures or a video beside the interface, in a thread of its own. Ends with its object,
// cancelled.
class RenderJob {
 public:
  RenderJob(RenderTask task, PictureWriter writer);
  ~RenderJob();

  int total() const { return task_.last - task_.first + 1; }
  int written() const { return written_; }
  const RenderTask& task() const { return task_; }
  void Cancel() { cancel_ = true; }
  bool is_cancelled() const { return cancel_; }
  // How many pictures there are, or why there are not more; none before it has ended.
  std::optional<Result<int>> result() const;

 private:
  RenderTask task_;
  std::atomic<int> written_ = 0;
  std::atomic<bool> cancel_ = false, has_ended_ = false;
  std::optional<Result<int>> result_;  // written before has_ended_ is
  std::thread thread_;
};

// The settings of the render dialog.
struct RenderState {
  int width = 1280, height = 720;
  bool whole = false;  // from `first` to `last`, else the current frame
  int first = 0, last = 0;
  bool through_project_camera = false;
  bool overlays = false;  // paths, marks and tint as in the viewport
  std::string folder;
  std::string error;
  std::shared_ptr<RenderJob> job;
  // How many of the files that will be written are there already, and of which files that was
  // counted.
  int num_existing = 0;
  std::string counted;
  // Of which document the range is, and all of its frames then.
  long document = -1;
  ProjectFrames document_frames;
};

// What the dialog says would be drawn: files and frames, of a project that need not be baked.
RenderTask OutlineOf(const Editor& editor);
// "31 pictures, 1280 x 720, Untitled_0000.png to Untitled_0030.png in /home/me/render".
std::string SummaryOf(const RenderTask& task);
// Of a project's name, or else its file's, what a file's name may have.
std::string ProjectNameOf(const Editor& editor);
std::string FileNameFrom(std::string name);
// What is wrong with a range or a size, in the interface's language; empty: nothing.
std::string RangeTrouble(int first, int last, const ProjectFrames& frames);
std::string SizeTrouble(int width, int height);
// The outline with all that is drawn. Errors: those of Session::WholeMotion.
Result<RenderTask> FilledTask(Editor* editor, RenderTask outline, bool through_project_camera,
                              bool overlays);
// Draws it, and shows how far that is.
void StartJob(RenderTask task, Editor* editor);
// How many of a task's files are there already.
int CountExisting(const RenderTask& task);

}  // namespace hazumi::ui
