#pragma once

#include <imgui.h>

#include "ui/panels/dope_sheet/muscle.h"
#include "ui/panels/window/geometry.h"

namespace hazumi::ui {

// Limp a pendulum, torque an arrow around, a spring a zigzag, keys a diamond, several kinds dots.
void DrawMuscleMark(ImDrawList* list, Point center, float radius, Muscle kind, ImU32 color);

}  // namespace hazumi::ui
