#pragma once

#include "ui/panels/sheet/frame.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// Opens the small window of a marker, by its index: its name, and a way to take it away.
void OpenMarker(Editor* editor, int marker);
// What is in it.
void DrawMarkerItems(Editor* editor);

// The marker whose sign or name is under a point, or -1.
int MarkerUnder(const Editor& editor, const SheetFrame& frame, Point p);

}  // namespace hazumi::ui
