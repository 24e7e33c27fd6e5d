#pragma once

#include "ui/panels/dope_sheet/layout.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// Acts on the mouse over the dope sheet. To be called with the panel's item as ImGui's last one.
// True if what is seen may not be where the layout has it any more.
bool TakeDopeSheetInput(Editor* editor, const DopeSheetLayout& layout);

}  // namespace hazumi::ui
