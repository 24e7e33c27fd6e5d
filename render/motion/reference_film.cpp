#include "render/motion/reference_film.h"

#include <cmath>
#include <utility>

#include "engine/spatial/degrees.h"

namespace hazumi::render {

namespace {

PicturePlane PlaneOf(const ProjectReference& reference, std::shared_ptr<const Image> image) {
  PicturePlane plane;
  plane.opacity = reference.opacity;
  plane.is_background = reference.view == ReferenceView::kBackground;
  const double width = reference.height_m * image->width / image->height;
  const double turn = reference.turn_deg * kDegree;
  plane.right = width * Vec3(std::cos(turn), std::sin(turn), 0.0);
  plane.up = reference.height_m * Vec3::UnitZ();
  plane.corner = reference.center_m - 0.5 * (plane.right + plane.up);
  plane.image = std::move(image);
  return plane;
}

}  // namespace

Result<ReferenceFilm> ReferenceFilm::Load(const std::string& path, FrameRate shown,
                                          FrameRate project,
                                          const std::function<bool()>& is_cancelled) {
  Result<Film> film = DecodeFilm(path, shown.num, shown.den, is_cancelled);
  if (!film.ok()) return film.error();
  return ReferenceFilm(std::make_shared<const Film>(std::move(film).value()), shown, project);
}

// A picture file is seen always.
int ReferenceFilm::IndexAt(const ProjectReference& reference, int frame) const {
  if (film_->count() == 1) return 0;
  const double start = shown_.FrameAt(project_.SecondsAt(reference.start_frame));
  return frame - static_cast<int>(std::lround(start));
}

Result<Done> ReferenceFilm::AddTo(const ProjectReference& reference, int frame, Scene* scene) {
  if (!film_ || reference.mute || reference.opacity <= 0.0) return Done();
  const int index = IndexAt(reference, frame);
  if (index < 0 || index >= film_->count()) return Done();
  if (index != index_) {
    Result<Image> image = film_->PictureAt(index);
    if (!image.ok()) return image.error();
    image_ = std::make_shared<const Image>(std::move(image).value());
    index_ = index;
  }
  scene->pictures.push_back(PlaneOf(reference, image_));
  return Done();
}

}  // namespace hazumi::render
