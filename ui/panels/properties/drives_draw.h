#pragma once

#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// Rows for the drives of a region, a copy of the project's.
void DrawDrives(Editor* editor, const ProjectRegion& region);

}  // namespace hazumi::ui
