#pragma once

#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// Each draws a panel into its rectangle and passes on what the user does in it. To be called
// between ImGui's NewFrame and Render.
void DrawMenuBar(Editor* editor, const Rect& rect);
void DrawViewport(Editor* editor, const Rect& rect);
void DrawTimeline(Editor* editor, const Rect& rect);
void DrawDopeSheet(Editor* editor, const Rect& rect);
void DrawGraph(Editor* editor, const Rect& rect);
void DrawOutliner(Editor* editor, const Rect& rect);
void DrawProperties(Editor* editor, const Rect& rect);
void DrawStatusBar(Editor* editor, const Rect& rect);
// Questions, the file dialog, search: whatever is on top of the panels.
void DrawDialogs(Editor* editor, const Rect& window);
// Asks about work that a crash left behind.
void DrawRecovery(Editor* editor);

// Until what is under the mouse is explained, if it stays there [s]; not positive: now.
double SecondsToTooltip();

// All of them, splitters, shortcuts and the tool in hand.
void DrawWindow(Editor* editor, float width, float height);

}  // namespace hazumi::ui
