#pragma once

#include "ui/panels/window/widgets.h"

namespace hazumi::ui {

// Small signs, drawn as shapes so that none depends on a font.
void DrawHatch(ImDrawList* list, const Rect& rect, ImU32 color);  // computed by a region
void DrawDiamond(ImDrawList* list, Point center, float radius, ImU32 color, bool is_filled);
// An eye, open or shut, and a padlock, as wide as high.
void DrawEye(ImDrawList* list, Point center, float radius, ImU32 color, bool is_open);
void DrawLock(ImDrawList* list, Point center, float radius, ImU32 color, bool is_locked);
void DrawDot(ImDrawList* list, Point center, float radius, ImU32 color);
// Points down when open, else to the right.
void DrawTriangle(ImDrawList* list, Point center, float radius, ImU32 color, bool is_open);

}  // namespace hazumi::ui
