#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "app/cli/commands.h"
#include "app/cli/exit_codes.h"
#include "app/cli/frame_names.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/cli/report_text.h"
#include "app/cli/terminal.h"
#include "app/cli/version.h"
#include "engine/bake/bake.h"
#include "engine/base/text.h"
#include "render/motion/figure_skin.h"
#include "render/motion/framing.h"
#include "render/motion/motion_scene.h"
#include "render/pipeline/sequence.h"

namespace hazumi {

namespace {

PictureSize PictureSizeOf(const Options& options) {
  return options.size.value_or(PictureSize{1280, 720});
}

render::Camera CameraFor(const BakedProject& baked, const Options& options) {
  const PictureSize size = PictureSizeOf(options);
  const double aspect = static_cast<double>(size.width) / size.height;
  render::Camera camera;
  if (options.camera && options.camera->side.empty()) {
    camera.eye = options.camera->eye;
    camera.target = options.camera->target;
    camera.vertical_fov_deg = options.camera->vertical_fov_deg;
  } else if (options.camera || !baked.project.camera) {
    const std::string side = options.camera ? options.camera->side : "three-quarter";
    camera = render::FrameMotion(baked.animation, baked.motion, side, aspect);
  } else {
    camera.eye = baked.project.camera->eye_m;
    camera.target = baked.project.camera->target_m;
    camera.vertical_fov_deg = baked.project.camera->vertical_fov_deg;
  }
  return camera;
}

std::string WithoutControls(std::string text) {
  std::erase_if(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; });
  return text;
}

std::string Text(const FrameRange& range) {
  if (range.first == range.last) return std::to_string(range.first);
  return std::to_string(range.first) + ".." + std::to_string(range.last);
}

// No dates, so that equal input gives equal bytes.
std::vector<render::PngText> Metadata(const BakedProject& baked, int frame) {
  const SolverSettings& solver = baked.animation.solver;
  return {{"Software", std::string("Hazumi ") + kVersion},
          {"Project", WithoutControls(baked.project.name)},
          {"Frame", std::to_string(frame)},
          {"Solver", FinenessText(solver.method, solver.step, solver.tolerance) + ", version " +
                         std::to_string(solver.version)}};
}

// The output frames asked for, as far as the motion has them.
std::optional<FrameRange> ChosenFrames(const Motion& motion, const Options& options) {
  if (motion.frames.empty()) {  // at an --fps so low that all fall outside
    ComplainOfUsage("--fps: no output frame lies within " + options.files[0]);
    return std::nullopt;
  }
  const FrameRange all{motion.frames.front().frame, motion.frames.back().frame};
  const FrameRange asked = options.frames.value_or(all);
  const FrameRange chosen{std::max(asked.first, all.first), std::min(asked.last, all.last)};
  const std::string has =
      "--frames " + Text(asked) + ": " + options.files[0] + " has frames " + Text(all);
  if (chosen.first > chosen.last) {
    ComplainOfUsage(has);
    return std::nullopt;
  }
  if (chosen.first != asked.first || chosen.last != asked.last) {
    PrintLine(stderr, "hazumi: warning: %s; drawing %s", has.c_str(), Text(chosen).c_str());
  }
  return chosen;
}

// At so many frames a second that paths are smooth.
Result<Motion> PathMotion(const BakedProject& baked, bool wanted) {
  if (!wanted) return Motion();
  FrameRate rate = baked.motion.rate;
  if (rate.num <= std::numeric_limits<int>::max() / 4) rate.num *= 4;
  return Bake(baked.animation, {rate, &Interrupted()});
}

render::SequenceOptions SettingsFrom(const Options& options) {
  render::SequenceOptions settings;
  settings.width = PictureSizeOf(options).width;
  settings.height = PictureSizeOf(options).height;
  settings.renderer.samples = options.samples;
  settings.renderer.shadow = options.shadow;
  settings.threads = std::min(options.threads, 2);
  return settings;
}

// What the callbacks of a sequence need.
struct Pictures {
  const BakedProject& baked;
  FrameRange frames;
  FrameNames names;
  render::MotionScene scenes;
  Progress progress;

  int count() const { return frames.last - frames.first + 1; }
  // A motion has all frames from its first to its last.
  int MotionIndex(int i) const { return frames.first + i - baked.motion.frames.front().frame; }
  std::string Name(int i) const { return names.Of(frames.first + i); }
};

render::Sequence SequenceOf(Pictures* pictures) {
  render::Sequence sequence;
  sequence.frame_count = pictures->count();
  sequence.scene = [=](int i) { return pictures->scenes.At(pictures->MotionIndex(i)); };
  sequence.path = [=](int i) { return std::filesystem::path(pictures->Name(i)); };
  sequence.metadata = [=](int i) { return Metadata(pictures->baked, pictures->frames.first + i); };
  sequence.progress = [=](int done) { pictures->progress.Report(done, pictures->Name(done - 1)); };
  sequence.cancel = &Interrupted();
  return sequence;
}

int RenderBaked(const BakedProject& baked, const FrameRange& frames, const Options& options) {
  const Result<Motion> path_motion = PathMotion(baked, options.paths);
  if (!path_motion.ok()) return Complain(path_motion.error());
  const Result<FrameNames> names = FrameNames::Create(options.output);
  if (!names.ok()) return Complain(names.error());
  render::Overlays overlays;
  overlays.ghost_every = options.ghosts;
  overlays.paths = options.paths;
  overlays.contact_marks = options.marks;
  overlays.region_tint = options.tint;
  overlays.frame_number = options.frame_number;
  render::SkinCache skins;
  const Result<render::FigureSkin> skin =
      skins.On(*baked.animation.figure, baked.project.skin.skin);
  if (!skin.ok()) return Complain(skin.error());
  if (skin.value()) PrintWarnings(options.files[0], skin.value().model->warnings);
  Pictures pictures{baked, frames, names.value(),
                    render::MotionScene(baked.animation, baked.motion, path_motion.value(),
                                        CameraFor(baked, options), overlays, skin.value()),
                    Progress("render", frames.last - frames.first + 1)};
  const Result<int> written = RenderSequence(SettingsFrom(options), SequenceOf(&pictures));
  pictures.progress.Finish();
  if (!written.ok()) return Complain(written.error());
  return Interrupted() ? Complain(InterruptedError()) : kExitOk;
}

}  // namespace

int RunRender(const Options& options) {
  const Result<BakedProject> baked = LoadAndBake(options.files[0], options);
  if (!baked.ok()) return Complain(baked.error());
  PrintWarnings(options.files[0], baked.value().warnings);
  const std::optional<FrameRange> frames = ChosenFrames(baked.value().motion, options);
  return frames ? RenderBaked(baked.value(), *frames, options) : kExitUsage;
}

}  // namespace hazumi
