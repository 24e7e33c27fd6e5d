#include "ui/panels/panels.h"
#include "ui/panels/widgets.h"

namespace hazumi::ui {

void DrawProperties(Editor* editor, const Rect& rect) {
  BeginPanel("##properties_draw", rect, editor->theme().panel);
  EndPanel();
}

}  // namespace hazumi::ui
