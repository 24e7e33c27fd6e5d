#pragma once

// Small windows over the dope sheet and the graph editor.

#include <optional>
#include <string>

#include "ui/panels/sheet/frame.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// A field for a name in a small window, which has the keyboard when that opens; Enter closes it.
// Gives the name once another one was typed.
std::optional<std::string> NameField(Editor* editor, const std::string& name);

// Opens the small window of a marker, by its index: its name, and a way to take it away.
void OpenMarker(Editor* editor, int marker);
// What is in it.
void DrawMarkerItems(Editor* editor);

// The marker whose sign or name is under a point, or -1.
int MarkerUnder(const Editor& editor, const SheetFrame& frame, Point p);

// Opens and draws the small windows that keys and the right button open. Called by both sheets.
void DrawSheetPopups(Editor* editor);

}  // namespace hazumi::ui
