#include "app/cli/pictures.h"

#include <algorithm>
#include <limits>

#include "app/cli/interrupt.h"
#include "app/cli/terminal.h"
#include "engine/bake/bake.h"
#include "engine/bake/bake_size.h"
#include "engine/project/project_files.h"
#include "render/motion/framing.h"
#include "ui/edit/media_files.h"

namespace hazumi {

namespace {

std::string Text(const FrameRange& range) {
  if (range.first == range.last) return std::to_string(range.first);
  return std::to_string(range.first) + ".." + std::to_string(range.last);
}

render::Camera CameraFor(const BakedProject& baked, PictureSize size, const Options& options) {
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

render::Overlays OverlaysOf(const Options& options, size_t num_frames) {
  render::Overlays overlays;
  overlays.look = options.body;
  overlays.ghosts = render::EveryNth(options.ghosts, num_frames);
  overlays.paths = options.paths;
  overlays.contact_marks = options.marks;
  overlays.region_tint = options.tint;
  overlays.frame_number = options.frame_number;
  return overlays;
}

}  // namespace

// Each picture has all ghosts.
bool HasFewGhosts(const Motion& motion, const Options& options) {
  constexpr size_t kMost = 1000;
  const size_t frames = motion.frames.size();
  if (options.ghosts == 0 || frames / static_cast<size_t>(options.ghosts) <= kMost) return true;
  ComplainOfUsage("--ghosts " + std::to_string(options.ghosts) + ": " +
                  std::to_string(frames / static_cast<size_t>(options.ghosts)) +
                  " ghosts in each picture; 1000 are the most, give at least " +
                  std::to_string((frames + kMost - 1) / kMost));
  return false;
}

std::optional<FrameRange> ChosenFrames(const Motion& motion, const Options& options,
                                       const char* doing) {
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
    PrintLine(stderr, "hazumi: warning: %s; %s %s", has.c_str(), doing, Text(chosen).c_str());
  }
  return chosen;
}

PictureSize PictureSizeOf(const Options& options) {
  return options.size.value_or(PictureSize{1280, 720});
}

render::SequenceOptions SequenceOptionsOf(const Options& options, PictureSize size) {
  render::SequenceOptions settings;
  settings.width = size.width;
  settings.height = size.height;
  settings.renderer.samples = options.samples;
  settings.renderer.shadow = options.shadow;
  settings.threads = std::min(options.threads, 2);
  return settings;
}

// Four points a frame, or fewer where the memory for them would be too much.
Result<Motion> PathMotion(const BakedProject& baked, const Options& options) {
  if (!options.paths) return Motion();
  FrameRate rate = baked.motion.rate;
  const double taken = MotionBytes(baked.animation, rate);
  for (const int points : {4, 2, 1}) {
    rate.num = baked.motion.rate.num;
    if (rate.num > std::numeric_limits<int>::max() / points) continue;
    rate.num *= points;
    if (taken + MotionBytes(baked.animation, rate) > kMostMotionBytes) continue;
    if (points < 4) {
      PrintLine(stderr, "hazumi: warning: --paths: %d points a frame instead of 4: memory", points);
    }
    return Bake(baked.animation, {rate, &Interrupted()});
  }
  Error error = *CheckBytes(taken + MotionBytes(baked.animation, rate), baked.animation, rate);
  error.place = "--paths";
  return error;
}

Result<render::FigureSkin> SkinOn(const BakedProject& baked, const std::string& file) {
  Result<render::FigureSkin> skin =
      render::SkinCache().On(*baked.animation.figure, baked.project.skin.meshes());
  if (skin.ok() && skin.value()) PrintWarnings(file, skin.value().model->warnings);
  return skin;
}

Result<render::ThingModels> ThingsOf(const BakedProject& baked, const std::string& file) {
  Result<render::ThingModels> things = render::ThingCache().Of(baked.animation.held_objects);
  if (!things.ok()) return things;
  for (const auto& model : things.value()) {
    if (model) PrintWarnings(file, model->warnings);
  }
  return things;
}

Result<render::ReferenceFilm> FilmOf(const BakedProject& baked, const std::string& file,
                                     bool open_outside) {
  const Project& project = baked.project;
  if (!edit::RenderedReference(project)) return render::ReferenceFilm();
  const edit::MediaAccess access(open_outside);
  if (auto closed = edit::WhyClosedToPictures(project, file, access)) return *closed;
  return render::ReferenceFilm::Load(ReferencePath(project, file), baked.motion.rate,
                                     {project.fps.num, project.fps.den},
                                     [] { return Interrupted().load(); });
}

Pictures::Pictures(const BakedProject& baked, const FrameRange& frames, const Motion& path_motion,
                   render::FigureSkin skin, render::ThingModels things, render::ReferenceFilm film,
                   PictureSize size, const Options& options)
    : baked_(baked),
      frames_(frames),
      scenes_(baked.animation, baked.motion, path_motion, CameraFor(baked, size, options),
              OverlaysOf(options, baked.motion.frames.size()), std::move(skin), std::move(things)),
      film_(std::move(film)) {}

render::Sequence Pictures::Sequence() {
  render::Sequence sequence;
  sequence.frame_count = count();
  // A motion has all frames from its first to its last.
  const int offset = frames_.first - baked_.motion.frames.front().frame;
  sequence.scene = [this, offset](int i) -> Result<render::Scene> {
    render::Scene scene = scenes_.At(offset + i);
    if (const auto& reference = baked_.project.reference) {
      const Result<Done> added = film_.AddTo(*reference, FrameOf(i), &scene);
      if (!added.ok()) return added.error();
    }
    return scene;
  };
  sequence.cancel = &Interrupted();
  return sequence;
}

}  // namespace hazumi
