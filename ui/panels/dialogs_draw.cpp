#include "ui/panels/panels.h"

namespace hazumi::ui {

void DrawDialogs(Editor*, const Rect&) {}

}  // namespace hazumi::ui
