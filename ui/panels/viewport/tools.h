#pragma once

#include <optional>
#include <string>

#include "ui/panels/viewport/gizmo.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// A tool that was begun by pressing the mouse button: it is confirmed when the button comes up.
struct HeldFrom {
  Point mouse;
};

// Each puts a tool in hand, or says why it cannot.

// Turns the selected joints about the hinge nearest to the view's axis, or to the one typed.
Result<Done> TakeRotateTool(Editor* editor);
// Turns one hinge by its ring.
void TakeRingTool(Editor* editor, const GizmoHit& ring, HeldFrom held);
// Drags the selected joint by inverse kinematics, or the selected object.
Result<Done> TakeMoveTool(Editor* editor);
void TakeReachTool(Editor* editor, const std::string& joint, HeldFrom held);
// Moves the root, with its feet or above them; turns it, or does so by one of its rings.
void TakeRootMoveTool(Editor* editor, std::optional<HeldFrom> held);
void TakeRootTurnTool(Editor* editor);
void TakeRootRingTool(Editor* editor, const GizmoHit& ring, HeldFrom held);
// Drags the end of a limit.
void TakeLimitTool(Editor* editor, const GizmoHit& end);

}  // namespace hazumi::ui
