#pragma once

#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// The fields of the chosen span of placement or hold, as rows of the properties: in these, and in
// the small window that a double click on its bar opens.
void DrawSpanFields(Editor* editor);

}  // namespace hazumi::ui
