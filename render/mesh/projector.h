#pragma once

#include <vector>

#include "render/mesh/flat_mesh.h"
#include "render/scene/camera.h"

namespace hazumi::render {

// Brings world points to the picture.
class Projector {
 public:
  Projector(const Camera& camera, PictureSize size);

  const Mat4& clip_from_world() const { return clip_from_world_; }
  PictureSize size() const { return size_; }
  double near_m() const { return near_m_; }

  // The visible pieces of a line through `points` [m, world]: it is cut where it goes behind the
  // viewer.
  std::vector<std::vector<ScreenPoint>> ProjectLine(const std::vector<Vec3>& points) const;

 private:
  ScreenPoint ToScreen(const Eigen::Vector4d& clip) const;

  Mat4 clip_from_world_;
  PictureSize size_;
  double near_m_;
};

}  // namespace hazumi::render
