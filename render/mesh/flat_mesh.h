#pragma once

#include <Eigen/Core>
#include <vector>

#include "render/scene/color.h"

namespace hazumi::render {

// A vertex of a flat mark, already projected: GL normalised device coordinates. A stroke is
// smoothed across: a fragment `side_px` from the middle line covers
// clamp(half_width_px + 0.5 - |side_px|, 0, 1).
struct FlatVertex {
  float x, y, z;
  float side_px, half_width_px;
  float srgba[4];
};

// Independent triangles, in drawing order.
using FlatMesh = std::vector<FlatVertex>;

// A point of the picture: pixels from the lower left corner, and depth in [-1, 1].
struct ScreenPoint {
  Eigen::Vector2d px{0.0, 0.0};
  double depth = 0.0;
};

struct PictureSize {
  int width = 0, height = 0;  // [px]
};

struct Stroke {
  double width_px = 1.0;
  SrgbColor color;
};

// A line through the points with mitred joins and square ends. Points closer than a third of a
// pixel to the one before are skipped.
void AppendStroke(const std::vector<ScreenPoint>& points, const Stroke& stroke, PictureSize size,
                  FlatMesh& mesh);

// A filled convex polygon (no smoothing: draw a stroke around it, or multisample).
void AppendFill(const std::vector<ScreenPoint>& corners, const SrgbColor& color, PictureSize size,
                FlatMesh& mesh);

}  // namespace hazumi::render
