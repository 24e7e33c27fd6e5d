#pragma once

#include <string>

#include "ui/panels/viewport/camera.h"
#include "ui/panels/window/scaled.h"
#include "ui/panels/window/widgets.h"

namespace hazumi::ui {

// Lines, arrows and texts over the picture of the scene.

// From a point to another, with a head where it ends.
void DrawArrow(Point from, Point to, ImU32 color, float width);
void DrawDashedLine(Point from, Point to, ImU32 color, float width);
// Readable on any picture.
void DrawShadedText(const ImVec2& at, const char* text);
// In a box beside a point, where there is room for it; as many lines as it takes.
void DrawLabel(const Editor& editor, const Rect& within, Point beside, const std::string& text,
               ImU32 color);

}  // namespace hazumi::ui
