#include "ui/panels/panels.h"
#include "ui/panels/widgets.h"

namespace hazumi::ui {

void DrawDopeSheet(Editor* editor, const Rect& rect) {
  BeginPanel("##dope_sheet_draw", rect, editor->theme().panel);
  EndPanel();
}

}  // namespace hazumi::ui
