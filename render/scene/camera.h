#pragma once

#include <Eigen/Core>

#include "engine/spatial/types.h"

namespace hazumi::render {

using Mat4 = Eigen::Matrix4d;

// A perspective camera in world coordinates (z up, right-handed, metres).
// `eye` and `target` must differ; `up` may be parallel to the view (then +y, or +x, stands in).
struct Camera {
  Vec3 eye{3.0, -4.0, 1.5};
  Vec3 target{0.0, 0.0, 0.9};
  Vec3 up{0.0, 0.0, 1.0};
  double vertical_fov_deg = 35.0;
  double near_m = 0.05;
  double far_m = 300.0;
};

// Takes world coordinates to eye coordinates (x right, y up, z towards the viewer).
Mat4 ViewMatrix(const Camera& camera);

// Takes eye coordinates to GL clip coordinates. `aspect` is width over height.
Mat4 ProjectionMatrix(const Camera& camera, double aspect);

}  // namespace hazumi::render
