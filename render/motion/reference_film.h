#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "engine/media/decode_film.h"
#include "engine/project/project_scene.h"
#include "engine/timeline/frame_time.h"
#include "render/scene/scene.h"

namespace hazumi::render {

// A project's reference picture or video, put into scenes. Keeps the picture that it showed last.
class ReferenceFilm {
 public:
  ReferenceFilm() = default;
  // `film`: at `shown` frames a second. `project`: those that the reference's start is said in.
  ReferenceFilm(std::shared_ptr<const Film> film, FrameRate shown, FrameRate project)
      : film_(std::move(film)), shown_(shown), project_(project) {}

  // At `shown` frames a second. Errors: of DecodeFilm.
  static Result<ReferenceFilm> Load(const std::string& path, FrameRate shown, FrameRate project,
                                    const std::function<bool()>& is_cancelled);

  // On a frame, of those shown; nothing where the video has none. Errors: of Film::PictureAt.
  Result<Done> AddTo(const ProjectReference& reference, int frame, Scene* scene);

 private:
  int IndexAt(const ProjectReference& reference, int frame) const;

  std::shared_ptr<const Film> film_;
  FrameRate shown_, project_;
  int index_ = -1;
  std::shared_ptr<const Image> image_;
};

}  // namespace hazumi::render
