#pragma once

#include <array>
#include <vector>

#include "ui/panels/viewport/camera.h"

namespace hazumi::ui {

// Buttons of these widths in the upper right corner, in order from left to right; those that find
// no room go to a row below.
std::vector<Rect> LayOutToggles(const Rect& viewport, const std::vector<float>& widths,
                                float height, double scale);

// An axis of the world as the cross in the lower left corner shows it.
struct CrossAxis {
  int axis;     // 0 x, 1 y, 2 z
  Point end;    // of its positive half
  double near;  // greater: nearer to the viewer
};
struct AxisCross {
  Point center;
  std::array<CrossAxis, 3> axes;  // the farthest first: the order to draw them in
};
AxisCross LayOutAxisCross(const View& view, double scale);

}  // namespace hazumi::ui
