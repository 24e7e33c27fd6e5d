#pragma once

#include <memory>

#include "ui/panels/dope_sheet/layout.h"
#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// How strong the spring of a region's bar is, by pulling it up or down. The bar is the chosen one.
std::unique_ptr<Tool> MakeDragStrength(Editor* editor, Point start, const RowBar& bar);

}  // namespace hazumi::ui
