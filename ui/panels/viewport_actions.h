#pragma once

#include "ui/panels/editor.h"

namespace hazumi::ui {

// What the viewport's keys do beside the document.
Result<Done> FrameSelected(Editor* editor);
Result<Done> FrameAll(Editor* editor);
Result<Done> LookThroughCamera(Editor* editor);
// Each frame; what the mouse does on the viewport, which is the item drawn last.
void ActOnViewport(Editor* editor, const Rect& rect);

}  // namespace hazumi::ui
