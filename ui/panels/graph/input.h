#pragma once

#include "ui/panels/graph/layout.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// Acts on the mouse over the graph. To be called with the panel's item as ImGui's last one.
void TakeGraphInput(Editor* editor, const GraphLayout& layout);

}  // namespace hazumi::ui
