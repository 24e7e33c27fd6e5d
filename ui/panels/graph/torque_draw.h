#pragma once

#include <imgui.h>

#include "ui/panels/graph/layout.h"

namespace hazumi::ui {

// Told apart on dark and on light ground.
SrgbColor CurveColor(int index);

// The torques below the curves, and the band of what muscles can give.
void DrawTorque(ImDrawList* list, const Editor& editor, const GraphLayout& layout);

}  // namespace hazumi::ui
