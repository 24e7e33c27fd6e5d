#include "ui/shell/picture_writer.h"

#include <filesystem>

#include "engine/base/version.h"
#include "render/motion/figure_skin.h"
#include "render/motion/reference_film.h"
#include "render/pipeline/offscreen.h"
#include "render/pipeline/sequence.h"
#include "render/pipeline/video.h"

namespace hazumi::ui {

namespace {

std::string WithoutControls(std::string text) {
  std::erase_if(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; });
  return text;
}

Result<Done> MakeFolder(const std::string& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (!failed) return Done();
  return Error{ErrorCode::kCannotWrite, folder, "", "cannot be made: " + failed.message()};
}

// The pictures as files, with what they are of.
void NameFiles(const RenderTask& task, render::Sequence* sequence) {
  sequence->path = [&task](int i) {
    return std::filesystem::path(PictureName(task, task.first + i));
  };
  sequence->metadata = [&task](int i) {
    return std::vector<render::PngText>{{"Software", std::string("Hazumi ") + kVersion},
                                        {"Project", WithoutControls(task.project)},
                                        {"Frame", std::to_string(task.first + i)}};
  };
}

Result<render::ReferenceFilm> FilmOf(const RenderTask& task, const std::atomic<bool>* cancel) {
  if (!task.reference) return render::ReferenceFilm();
  return render::ReferenceFilm::Load(task.reference_path, task.motion.rate, task.reference_rate,
                                     [cancel] { return cancel && *cancel; });
}

}  // namespace

Result<int> WritePictures(const RenderTask& task, const std::function<void(int)>& written,
                          const std::atomic<bool>* cancel) {
  const bool is_video = !task.video.empty();
  const Result<Done> made = is_video ? Done() : MakeFolder(task.folder);
  if (!made.ok()) return made.error();
  render::SkinCache skins;
  const Result<render::FigureSkin> skin = skins.On(*task.animation.figure, task.skin.meshes());
  if (!skin.ok()) return skin.error();
  render::ThingCache cache;
  const Result<render::ThingModels> things = cache.Of(task.animation.held_objects);
  if (!things.ok()) return things.error();
  render::MotionScene scenes(task.animation, task.motion, task.motion, task.camera, task.overlays,
                             skin.value(), things.value());
  Result<render::ReferenceFilm> film = FilmOf(task, cancel);
  if (!film.ok()) return film.error();
  render::SequenceOptions options;
  options.width = task.width;
  options.height = task.height;
  options.renderer.shadow = task.shadow;
  options.threads = 1;  // the interface has the other one
  render::Sequence sequence;
  sequence.frame_count = task.last - task.first + 1;
  const int skipped = task.first - task.motion.frames.front().frame;
  sequence.scene = [&](int i) -> Result<render::Scene> {
    render::Scene scene = scenes.At(skipped + i);
    if (task.reference) {
      const Result<Done> added = film.value().AddTo(*task.reference, task.first + i, &scene);
      if (!added.ok()) return added.error();
    }
    return scene;
  };
  sequence.progress = written;
  sequence.cancel = cancel;
  if (is_video) {
    const FrameRate& rate = task.motion.rate;
    return render::RenderVideo(
        options, sequence, {task.video, task.width, task.height, rate.num, rate.den, task.sound});
  }
  NameFiles(task, &sequence);
  return render::RenderSequence(options, sequence);
}

Result<std::vector<Image>> DrawPictures(const std::vector<render::Scene>& scenes, int edge_px) {
  constexpr render::RendererOptions kSmall = {4, false, 1};
  Result<render::OffscreenRenderer> renderer = render::OffscreenRenderer::Create(kSmall);
  if (!renderer.ok()) return renderer.error();
  std::vector<Image> pictures;
  for (const render::Scene& scene : scenes) {
    pictures.emplace_back(edge_px, edge_px);
    const Result<Done> drawn = renderer.value().Draw(scene, pictures.back());
    if (!drawn.ok()) return drawn.error();
  }
  return pictures;
}

}  // namespace hazumi::ui
