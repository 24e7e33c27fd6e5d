#include "app/cli/cell_pictures.h"

#include <algorithm>

#include "app/cli/interrupt.h"
#include "app/cli/pictures.h"
#include "engine/bake/bake.h"
#include "engine/base/version.h"
#include "engine/project/compile.h"
#include "render/image/png.h"
#include "render/motion/framing.h"
#include "render/pipeline/offscreen.h"
#include "render/pipeline/video.h"
#include "render/sheet/draw_text.h"
#include "ui/edit/media_files.h"

namespace hazumi {

namespace {

Error AtPicture(const std::string& place, const std::string& message) {
  return {ErrorCode::kSchema, "", "picture" + place, message};
}

Result<Options> OptionsOf(const Sweep& sweep) {
  const SweepPicture& picture = *sweep.plan().picture;
  std::vector<std::string> words = {"--render", "pictures"};
  words.insert(words.end(), picture.options.begin(), picture.options.end());
  words.push_back(sweep.project_file());
  Result<Options> options = ParseWords(words);
  if (!options.ok()) return AtPicture(".options", options.error().message);
  if (options.value().frames) {
    return AtPicture(".options", "--frames: say \"frames\" beside the options instead");
  }
  for (const std::string& word : options.value().given) {
    for (const char* other : {"--fps", "--method", "--tolerance", "--step"}) {
      if (word == other)
        return AtPicture(".options", word + " changes the motion, not the picture");
    }
  }
  return options;
}

FrameRange AllFrames(const Motion& motion) {
  return {motion.frames.front().frame, motion.frames.back().frame};
}

std::optional<Error> CheckFrames(const Sweep& sweep) {
  const ProjectFrames& all = sweep.project().frames;
  const auto& frames = sweep.plan().picture->frames;
  for (size_t i = 0; i < frames.size(); ++i) {
    if (frames[i] >= all.first && frames[i] <= all.last) continue;
    return AtPicture(
        ".frames[" + std::to_string(i) + "]",
        "the project has frames " + std::to_string(all.first) + " to " + std::to_string(all.last));
  }
  return std::nullopt;
}

// The options of drawing, with a size and on one thread, once all that is said of pictures is
// right.
Result<Options> CheckedOptions(const Sweep& sweep, bool open_outside) {
  Result<Options> options = OptionsOf(sweep);
  if (!options.ok()) return options;
  if (auto error = CheckFrames(sweep)) return *error;
  Options& chosen = options.value();
  chosen.open_outside = open_outside;  // whatever the sweep says
  const edit::MediaAccess access(open_outside);
  if (auto closed = edit::WhyClosedToPictures(sweep.project(), sweep.project_file(), access))
    return *closed;
  if (!chosen.size) chosen.size = PictureSize{240, 180};
  if (sweep.plan().picture->video &&
      (chosen.size->width % 2 != 0 || chosen.size->height % 2 != 0)) {
    return AtPicture(".options", "--size: videos have even sizes");
  }
  chosen.threads = 1;
  return options;
}

// All cells are seen from one place, so that they can be compared: that from which the project
// itself, unvaried, is seen in the frames that are drawn.
Result<Done> KeepCamera(const Sweep& sweep, PictureSize size, Options* options) {
  if (options->camera && options->camera->side.empty()) return Done();
  if (!options->camera && sweep.project().camera) return Done();
  const Result<Compiled> compiled = CompileAnimation(sweep.project());
  if (!compiled.ok()) return compiled.error();
  Result<Motion> motion = Bake(compiled.value().animation, {{}, &Interrupted()});
  if (!motion.ok()) return motion.error();
  const auto& drawn = sweep.plan().picture->frames;
  std::erase_if(motion.value().frames, [&](const MotionFrame& frame) {
    return !drawn.empty() && std::find(drawn.begin(), drawn.end(), frame.frame) == drawn.end();
  });
  const std::string side = options->camera ? options->camera->side : "three-quarter";
  const double aspect = static_cast<double>(size.width) / size.height;
  const render::Camera camera =
      render::FrameMotion(compiled.value().animation, motion.value(), side, aspect);
  options->camera = {"", camera.eye, camera.target, camera.vertical_fov_deg};
  return Done();
}

}  // namespace

struct CellPictures::Parts {
  const Sweep& sweep;
  const SweepStore& store;
  Options options;
  PictureSize size;
  render::OffscreenRenderer renderer;
  render::SkinCache skins;

  Result<Done> Draw(const SweptCell& cell);
  Result<Done> DrawStrip(const BakedProject& baked, long cell);
  Result<Done> DrawVideo(const BakedProject& baked, long cell);
  // Hands on each as it is drawn.
  Result<Done> DrawFrames(const BakedProject& baked, const std::vector<int>& frames,
                          const std::function<Result<Done>(const Image&)>& take);
};

CellPictures::CellPictures(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
CellPictures::~CellPictures() = default;
CellPictures::CellPictures(CellPictures&&) noexcept = default;

const char* PictureSuffix(const SweepPlan& plan) {
  if (!plan.picture) return nullptr;
  return plan.picture->video ? ".mp4" : ".png";
}

Result<Done> CellPictures::Check(const Sweep& sweep, bool open_outside) {
  const Result<Options> options = CheckedOptions(sweep, open_outside);
  if (!options.ok()) return options.error();
  return Done();
}

Result<CellPictures> CellPictures::Create(const Sweep& sweep, const SweepStore& store,
                                          bool open_outside) {
  Result<Options> options = CheckedOptions(sweep, open_outside);
  if (!options.ok()) return options.error();
  Options chosen = std::move(options).value();
  const PictureSize size = *chosen.size;
  const Result<Done> camera = KeepCamera(sweep, size, &chosen);
  if (!camera.ok()) return camera.error();
  auto renderer = render::OffscreenRenderer::Create(SequenceOptionsOf(chosen, size).renderer);
  if (!renderer.ok()) return renderer.error();
  return CellPictures(std::make_unique<Parts>(
      Parts{sweep, store, std::move(chosen), size, std::move(renderer).value(), {}}));
}

Result<Done> CellPictures::Draw(const SweptCell& cell) { return parts_->Draw(cell); }

Result<Done> CellPictures::Parts::Draw(const SweptCell& cell) {
  const BakedProject baked{cell.project, cell.animation, cell.motion, {}};
  return sweep.plan().picture->video ? DrawVideo(baked, cell.number)
                                     : DrawStrip(baked, cell.number);
}

Result<Done> CellPictures::Parts::DrawFrames(
    const BakedProject& baked, const std::vector<int>& frames,
    const std::function<Result<Done>(const Image&)>& take) {
  const Result<Motion> paths = PathMotion(baked, options);
  if (!paths.ok()) return paths.error();
  Result<render::FigureSkin> skin = skins.On(*baked.animation.figure, baked.project.skin.meshes());
  if (!skin.ok()) return skin.error();
  Result<render::ThingModels> things = render::ThingCache().Of(baked.animation.held_objects);
  if (!things.ok()) return things.error();
  Result<render::ReferenceFilm> film = FilmOf(baked, sweep.project_file(), options.open_outside);
  if (!film.ok()) return film.error();
  const FrameRange all = AllFrames(baked.motion);
  Pictures pictures(baked, all, paths.value(), std::move(skin).value(), std::move(things).value(),
                    std::move(film).value(), size, options);
  const render::Sequence sequence = pictures.Sequence();
  Image image(size.width, size.height);
  for (const int frame : frames) {
    if (Interrupted()) return InterruptedError();
    // A cell may have another last frame than the project.
    const Result<render::Scene> scene =
        sequence.scene(std::clamp(frame, all.first, all.last) - all.first);
    if (!scene.ok()) return scene.error();
    Result<Done> drawn = renderer.Draw(scene.value(), image);
    if (!drawn.ok()) return drawn;
    Result<Done> taken = take(image);
    if (!taken.ok()) return taken;
  }
  return Done();
}

Result<Done> CellPictures::Parts::DrawStrip(const BakedProject& baked, long cell) {
  const std::vector<int>& frames = sweep.plan().picture->frames;
  Image strip(size.width * static_cast<int>(frames.size()), size.height);
  int x = 0;
  Result<Done> drawn = DrawFrames(baked, frames, [&](const Image& image) -> Result<Done> {
    render::CopyInto(image, x, 0, &strip);
    x += size.width;
    return Done();
  });
  if (!drawn.ok()) return drawn;
  return render::WritePng(
      store.PicturePath(cell, ".png"), strip,
      {{"Software", std::string("Hazumi ") + kVersion}, {"Cell", std::to_string(cell)}});
}

Result<Done> CellPictures::Parts::DrawVideo(const BakedProject& baked, long cell) {
  const FrameRate& rate = baked.motion.rate;
  Result<render::VideoWriter> video = render::VideoWriter::Start(
      {store.PicturePath(cell, ".mp4"), size.width, size.height, rate.num, rate.den, {}});
  if (!video.ok()) return video.error();
  std::vector<int> frames;
  for (const MotionFrame& frame : baked.motion.frames) frames.push_back(frame.frame);
  Result<Done> drawn =
      DrawFrames(baked, frames, [&](const Image& image) { return video.value().Write(image); });
  if (!drawn.ok()) return drawn;
  return video.value().Finish(&Interrupted());
}

}  // namespace hazumi
