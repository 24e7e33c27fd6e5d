#pragma once

namespace hazumi::ui {

// The editor below the viewport.
enum class SheetKind { kDopeSheet, kGraph };

// The dope sheet and the graph editor: which frames and rows are seen.
struct SheetState {
  SheetKind kind = SheetKind::kDopeSheet;
  double first = -1.0, last = 32.0;  // frames at the left and right edge
  double scroll_px = 0.0;            // rows above the top edge
};

}  // namespace hazumi::ui
