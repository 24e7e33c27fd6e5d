#pragma once

#include <memory>
#include <string>

#include "ui/panels/dope_sheet/layout.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// The chosen bar is moved in time, or one of its ends is. `part`: kBar, kBarStart or kBarEnd. Null
// if no bar is chosen.
std::unique_ptr<Tool> MakeDragBar(Editor* editor, Point start, SheetPart part);

// Changes the strength of the spring of a region's bar by pulling it up or down. Requires that the
// bar is chosen.
std::unique_ptr<Tool> MakeDragStrength(Editor* editor, Point start, const RowBar& bar);

// The playhead follows the mouse; so does the pose.
std::unique_ptr<Tool> MakeScrub(Editor* editor, Point start);

// Waits for the button, then paints a new region over rows and frames. Enter instead marks the
// selected joints.
std::unique_ptr<Tool> MakePaintRegion(Editor* editor, Point start);

// A marker follows the mouse.
std::unique_ptr<Tool> MakeMoveMarker(Editor* editor, Point start, int marker);

// Waits for the button, then sets the preview range from where it is pressed to where it is let go.
std::unique_ptr<Tool> MakePreviewRange(Editor* editor, Point start);

// Frames that a region of the selected joints would have: those of the selected keys, else the
// preview range, else ten from the current one on.
ProjectFrames FramesToMark(const edit::Session& session);

// Whether a region that is made in the window touches the scene: if the project's method can.
bool TouchesWhenMade(const Project& project);

}  // namespace hazumi::ui
