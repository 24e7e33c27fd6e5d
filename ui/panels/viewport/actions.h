#pragma once

#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// What the viewport's keys do beside the document.
Result<Done> FrameSelected(Editor* editor);
Result<Done> FrameAll(Editor* editor);
// Once for each document: its whole motion comes into view, or a new project as it is by default,
// and all its frames.
void FrameNewDocument(Editor* editor);
Result<Done> LookThroughCamera(Editor* editor);
// The project gets a camera that looks as the view does.
Result<Done> SetCameraToView(Editor* editor);
// Each frame; what the mouse does on the viewport, which is the item drawn last.
void ActOnViewport(Editor* editor, const Rect& rect);

}  // namespace hazumi::ui
