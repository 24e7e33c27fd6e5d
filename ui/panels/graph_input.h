#pragma once

#include "ui/panels/editor.h"
#include "ui/panels/graph_layout.h"

namespace hazumi::ui {

// Acts on the mouse over the graph. To be called with the panel's item as ImGui's last one.
void TakeGraphInput(Editor* editor, const GraphLayout& layout);

// A handle follows the mouse and sets the rate of its key.
std::unique_ptr<Tool> MakeDragHandle(Editor* editor, Point start, const GraphKey& key, int side,
                                     const std::string& curve);

}  // namespace hazumi::ui
