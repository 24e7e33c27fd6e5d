#pragma once

#include <vector>

#include "render/mesh/projector.h"
#include "render/scene/scene.h"

namespace hazumi::render {

// Pixels from (left, bottom) to before (right, top); rows count upwards, as in OpenGL.
struct PictureArea {
  int left = 0, bottom = 0, right = 0, top = 0;

  int width() const { return right - left; }
  int height() const { return top - bottom; }
  double pixels() const { return is_empty() ? 0.0 : static_cast<double>(width()) * height(); }
  bool is_empty() const { return width() <= 0 || height() <= 0; }
  bool operator==(const PictureArea&) const = default;
};

// The area that the hull of points takes, and one pixel more on each side; the whole picture if a
// point is not before the viewer.
class PictureBounds {
 public:
  explicit PictureBounds(const Projector& projector);

  void Include(const Eigen::Vector3f& point);  // [m, world]
  // Of the cube around a sphere.
  void Include(const Vec3& center, double radius);
  PictureArea area() const;
  // At the nearest point; infinite if one is not before the viewer.
  double pixels_per_m() const;

 private:
  Eigen::Matrix4f clip_from_world_;
  PictureSize size_;
  float near_m_;
  bool is_before_viewer_ = true;
  float least_w_;
  Eigen::Vector2f min_, max_;  // normalised device coordinates: -1 to 1 is the picture
};

// Of all that has sharp edges and is no skin: each solid, ghosts too, and each filled marker.
std::vector<PictureArea> AreasOfEdges(const Scene& scene, const Projector& projector);

// At most three that do not overlap and hold all of `areas`. Empty ones are left out.
std::vector<PictureArea> Merged(std::vector<PictureArea> areas);

// The picture without `holes`, which do not overlap, in rectangles that do not overlap.
std::vector<PictureArea> AreasAround(const std::vector<PictureArea>& holes, PictureSize size);

}  // namespace hazumi::render
