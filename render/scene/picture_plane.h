#pragma once

#include <memory>

#include "engine/picture/image.h"
#include "engine/spatial/types.h"

namespace hazumi::render {

// A picture in the scene, lit by nothing: a plane, seen from both sides, or behind everything.
struct PicturePlane {
  std::shared_ptr<const Image> image;
  double opacity = 1.0;
  bool is_background = false;  // as large as the view holds it whole
  // Of a plane: where its lower left corner is, and its edges from there [m].
  Vec3 corner = Vec3::Zero(), right = Vec3::UnitX(), up = Vec3::UnitZ();
};

}  // namespace hazumi::render
