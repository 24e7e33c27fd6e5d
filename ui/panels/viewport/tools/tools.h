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

// Turns the selected joints about the hinge whose limits are shown, else the first one; R again
// takes the next, a letter the one nearest to that axis.
Result<Done> TakeRotateTool(Editor* editor);
// Turns one hinge by its ring, or all selected joints by one of theirs.
void TakeRingTool(Editor* editor, const GizmoHit& ring, HeldFrom held);
// Drags the selected joint by inverse kinematics, or the selected object.
Result<Done> TakeMoveTool(Editor* editor);
// Moves the selected box, held object in its hand, or held object's keys.
Result<Done> TakeMoveObjectTool(Editor* editor, std::optional<HeldFrom> held);
// Turns the selected held object in its hand.
Result<Done> TakeTurnObjectTool(Editor* editor);
// A jump from the current frame on, onto the spot under the mouse.
Result<Done> TakeJumpTool(Editor* editor);
// Aims the selected held object's throw at the spot under the mouse.
Result<Done> TakeThrowTool(Editor* editor);
// The tip of the selected joint's limb reaches the spot under the mouse in the current frame.
Result<Done> TakeAimTool(Editor* editor);
// The selected joint takes hold of what is clicked.
Result<Done> TakeHoldOnTool(Editor* editor);
// A new box, drawn onto what is under the mouse.
Result<Done> TakeAddBoxTool(Editor* editor);
void TakeReachTool(Editor* editor, const std::string& joint, HeldFrom held);
// Moves the root, with its feet or above them; turns it, or does so by one of its rings.
void TakeRootMoveTool(Editor* editor, std::optional<HeldFrom> held);
void TakeRootTurnTool(Editor* editor);
void TakeRootRingTool(Editor* editor, const GizmoHit& ring, HeldFrom held);
// Selects the joints in a rectangle.
Result<Done> TakeBoxTool(Editor* editor);
// Drags the place of a goal, or the top of its arc.
void TakeGoalTool(Editor* editor, const GoalPart& part, HeldFrom held);
// Drags the end of a limit.
void TakeLimitTool(Editor* editor, const GizmoHit& end);

}  // namespace hazumi::ui
