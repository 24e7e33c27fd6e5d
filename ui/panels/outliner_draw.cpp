#include "ui/panels/panels.h"
#include "ui/panels/widgets.h"

namespace hazumi::ui {

void DrawOutliner(Editor* editor, const Rect& rect) {
  BeginPanel("##outliner_draw", rect, editor->theme().panel);
  EndPanel();
}

}  // namespace hazumi::ui
