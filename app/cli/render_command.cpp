#include <cstdio>
#include <filesystem>

#include "app/cli/commands.h"
#include "app/cli/exit_codes.h"
#include "app/cli/frame_names.h"
#include "app/cli/interrupt.h"
#include "app/cli/progress.h"
#include "app/cli/version.h"
#include "engine/bake/bake.h"
#include "engine/base/text.h"
#include "render/motion/framing.h"
#include "render/motion/motion_scene.h"
#include "render/pipeline/sequence.h"

namespace hazumi {

namespace {

render::Camera CameraFor(const BakedProject& baked, const Options& options) {
  const double aspect = static_cast<double>(options.width) / options.height;
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

// No dates, so that equal input gives equal bytes.
std::vector<render::PngText> Metadata(const BakedProject& baked, int frame) {
  const SolverSettings& solver = baked.animation.solver;
  return {{"Software", std::string("Hazumi ") + kVersion},
          {"Project", baked.project.name},
          {"Frame", std::to_string(frame)},
          {"Solver", std::string(NameOf(solver.method)) + " " + FormatNumber(solver.step) +
                         " s, version " + std::to_string(solver.version)}};
}

// Indices of the motion's frames that are asked for.
Result<std::vector<int>> ChosenFrames(const Motion& motion, const Options& options) {
  std::vector<int> chosen;
  for (size_t i = 0; i < motion.frames.size(); ++i) {
    const int frame = motion.frames[i].frame;
    if (options.frames && (frame < options.frames->first || frame > options.frames->last)) continue;
    chosen.push_back(static_cast<int>(i));
  }
  if (!chosen.empty()) return chosen;
  return Error{ErrorCode::kSemantics, options.files[0], "frames",
               "none of the frames asked for is in the project"};
}

// At so many frames a second that paths are smooth.
Result<Motion> PathMotion(const BakedProject& baked, bool wanted) {
  if (!wanted) return Motion();
  const FrameRate rate = baked.motion.rate;
  return Bake(baked.animation, {FrameRate{rate.num * 4, rate.den}});
}

int RenderBaked(const BakedProject& baked, const Options& options) {
  const Result<std::vector<int>> chosen = ChosenFrames(baked.motion, options);
  if (!chosen.ok()) return Complain(chosen.error());
  const Result<FrameNames> names = FrameNames::Create(options.output);
  if (!names.ok()) return Complain(names.error());
  const std::vector<int>& frames = chosen.value();
  const auto number = [&](int i) { return baked.motion.frames[frames[i]].frame; };

  const render::Overlays overlays{options.ghosts, options.paths, options.marks, options.tint,
                                  options.frame_number};
  const Result<Motion> path_motion = PathMotion(baked, options.paths);
  if (!path_motion.ok()) return Complain(path_motion.error());
  render::MotionScene scenes(baked.animation, baked.motion, path_motion.value(),
                             CameraFor(baked, options), overlays);
  Progress progress("render", static_cast<int>(frames.size()));
  render::Sequence sequence;
  sequence.frame_count = static_cast<int>(frames.size());
  sequence.scene = [&](int i) { return scenes.At(frames[i]); };
  sequence.path = [&](int i) { return std::filesystem::path(names.value().Of(number(i))); };
  sequence.metadata = [&](int i) { return Metadata(baked, number(i)); };
  sequence.progress = [&](int done) { progress.Report(done, names.value().Of(number(done - 1))); };
  sequence.cancel = &Interrupted();
  render::SequenceOptions settings;
  settings.width = options.width;
  settings.height = options.height;
  settings.renderer.samples = options.samples;
  settings.renderer.shadow = options.shadow;
  settings.threads = options.threads;
  const Result<int> written = RenderSequence(settings, sequence);
  progress.Finish();
  if (!written.ok()) return Complain(written.error());
  return written.value() == sequence.frame_count ? kExitOk : kExitInterrupted;
}

}  // namespace

int RunRender(const Options& options) {
  const Result<BakedProject> baked = LoadAndBake(options.files[0], options);
  if (!baked.ok()) return Complain(baked.error());
  PrintWarnings(options.files[0], baked.value().warnings);
  return RenderBaked(baked.value(), options);
}

}  // namespace hazumi
