#pragma once

// Lines, arrows and texts over the picture of the scene, and the marks made of them.

#include <string>

#include "ui/panels/viewport/camera.h"
#include "ui/panels/viewport/gizmo.h"
#include "ui/panels/viewport/solids.h"
#include "ui/panels/window/editor.h"
#include "ui/panels/window/widgets.h"

namespace hazumi::ui {

// From a point to another, with a head where it ends.
void DrawArrow(Point from, Point to, ImU32 color, float width);
void DrawDashedLine(Point from, Point to, ImU32 color, float width);
// Readable on any picture.
void DrawShadedText(const ImVec2& at, const char* text);
// In a box beside a point, where there is room for it; as many lines as it takes.
void DrawLabel(const Editor& editor, const Rect& within, Point beside, const std::string& text,
               ImU32 color);

// Each draws something on top of the picture of the scene.
void DrawJointMarks(const Editor& editor, const View& view, const PosedFigure& figure);
// `more`: to be said beside its name.
void DrawHovered(const Editor& editor, const View& view, const PosedFigure& figure,
                 const std::vector<Solid>& solids, Point mouse, const std::string& more);
void DrawSelectedObject(const Editor& editor, const View& view, const std::vector<Solid>& solids);
void DrawAimedSpot(const Editor& editor, const View& view);
void DrawPathTicks(const Editor& editor, const View& view);
void DrawGizmo(const Editor& editor, const View& view, const Gizmo& gizmo,
               const std::optional<GizmoHit>& hovered);
void DrawAxisCross(const Editor& editor, const View& view);
void DrawCaption(const Editor& editor, const Rect& rect);
void DrawCameraBorder(const Editor& editor, const Rect& rect);
// Buttons that show and hide overlays.
void DrawToggles(Editor* editor, const Rect& rect);

}  // namespace hazumi::ui
