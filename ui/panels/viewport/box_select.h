#pragma once

#include <string>
#include <vector>

#include "ui/panels/viewport/camera.h"
#include "ui/panels/viewport/figure.h"

namespace hazumi::ui {

// Names of the joints whose marks are in a rectangle of the window, and of the root; not of hidden
// ones.
std::vector<std::string> JointsIn(const Rect& box, const View& view, const PosedFigure& figure);

}  // namespace hazumi::ui
