#include "ui/panels/panels.h"
#include "ui/panels/widgets.h"

namespace hazumi::ui {

void DrawGraph(Editor* editor, const Rect& rect) {
  BeginPanel("##graph_draw", rect, editor->theme().panel);
  EndPanel();
}

}  // namespace hazumi::ui
