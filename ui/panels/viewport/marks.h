#pragma once

#include "ui/panels/viewport/gizmo.h"
#include "ui/panels/viewport/solids.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

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
