#pragma once

#include <optional>

#include "ui/panels/window/geometry.h"

namespace hazumi::ui {

// How the window is shared out: the parts that splitters move, each in (0, 1).
struct Shares {
  double side = 0.24;      // of the width: outliner and properties
  double bottom = 0.36;    // of the height: dope sheet or graph editor
  double outliner = 0.38;  // of the side's height
  bool operator==(const Shares&) const = default;
};

struct WindowLayout {
  Rect menu, viewport, timeline, sheet, outliner, properties, status;
};

enum class Splitter { kSide, kBottom, kOutliner };

// The smallest size that a window is laid out in [px at scale 1]. What a smaller one has no room
// for is cut off.
constexpr float kLeastWidth = 480.0f, kLeastHeight = 300.0f;
Rect LeastWindow(const Rect& size, double scale);

// `scale`: of the interface, 1 at 96 dpi. `size`: of the window [px], x and y are 0.
WindowLayout LayOutWindow(const Rect& size, const Shares& shares, double scale);

// The splitter under a point.
std::optional<Splitter> SplitterAt(const WindowLayout& layout, Point p, double scale);
// The shares after a splitter was dragged to a point; no panel gets too small to use.
Shares DragSplitter(const Rect& size, const Shares& shares, Splitter splitter, Point to,
                    double scale);

// Where a tooltip of this size goes: beside the window that the item is in (a panel at the side, a
// menu, a dialog), so that it covers none of its other rows, if the item is not far from its edge
// and there is room; else below the item, or above it. Of an item as high as a panel, below the
// mouse.
Point TooltipPlace(const Rect& item, const Rect& window, Point mouse, Point size,
                   const Rect& screen, double scale);

}  // namespace hazumi::ui
