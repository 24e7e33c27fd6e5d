#pragma once

#include "ui/panels/dope_sheet/layout.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// Acts on the mouse over the dope sheet. To be called with the panel's item as ImGui's last one.
// True if what is seen may not be where the layout has it any more.
bool TakeDopeSheetInput(Editor* editor, const DopeSheetLayout& layout);

// The small windows that keys and the right button open, and what they do. Called by both sheets.
void DrawSheetPopups(Editor* editor);

}  // namespace hazumi::ui
