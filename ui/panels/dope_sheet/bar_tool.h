#pragma once

#include <memory>

#include "ui/panels/dope_sheet/layout.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// The chosen bar is moved in time, or one of its ends is. `part`: kBar, kBarStart or kBarEnd. Null
// if no bar is chosen.
std::unique_ptr<Tool> MakeDragBar(Editor* editor, Point start, SheetPart part);

}  // namespace hazumi::ui
