#include "ui/panels/panels.h"
#include "ui/panels/widgets.h"

namespace hazumi::ui {

void DrawTimeline(Editor* editor, const Rect& rect) {
  BeginPanel("##timeline_draw", rect, editor->theme().panel);
  EndPanel();
}

}  // namespace hazumi::ui
