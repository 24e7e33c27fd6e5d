#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/project/fields/field.h"
#include "engine/project/item_id.h"
#include "ui/panels/window/geometry.h"

namespace hazumi::ui {

// The editor below the viewport.
enum class SheetKind { kDopeSheet, kGraph };

// Small windows that a key opens at the mouse.
enum class SheetPopup {
  kNone,
  kInterpolation,
  kHandles,
  kKeyType,
  kBar,  // of the chosen bar
  kKeys,
  kMarker
};

// A kind of bar of the dope sheet, by what a bar stands for: bar_types.cpp.
using BarKind = Thing;
// A bar, by its index in the project's list of them (of holders, in that of all objects'):
// until something is edited.
struct BarRef {
  BarKind kind = BarKind::kRegion;
  int index = 0;
  bool operator==(const BarRef&) const = default;
};
// A bar for longer.
struct BarId {
  BarKind kind = BarKind::kRegion;
  ItemId id;
  bool operator==(const BarId&) const = default;
};

// Values from the lower to the upper edge of the graph.
struct ValueRange {
  double low = -90.0, high = 90.0;
  bool operator==(const ValueRange&) const = default;
};

// The dope sheet and the graph editor: which frames and rows are seen.
struct SheetState {
  SheetKind kind = SheetKind::kDopeSheet;
  double first = -1.0, last = 32.0;  // frames at the left and right edge
  double scroll_px = 0.0;            // rows above the top edge
  std::set<std::string> open;        // rows whose parts are shown, by SheetRow::id
  bool only_selected = false;        // rows of the selected joints alone
  std::optional<BarId> bar;          // that was clicked last
  std::string bar_row;               // row on which its popup was opened, by SheetRow::id
  ItemId marker;                     // that its small window is about
  Rect rect;                         // where it was drawn last [px]

  // The graph.
  ValueRange values;
  bool fits_values = true;          // the range follows what is shown
  bool normalize = false;           // each curve fills the height
  bool torque = false;              // what the motion needs, below the curves
  std::vector<std::string> curves;  // shown last
  std::set<std::string> hidden;     // curves that are not drawn

  // What a tool draws.
  std::optional<Rect> box;  // of a box selection
  struct Paint {
    int first_row = 0, last_row = 0;  // inclusive
    int first_frame = 0, last_frame = 0;
  };
  std::optional<Paint> paint;  // of a region to be
  bool is_quiet = false;       // a tool ended in this frame: the click that ended it does no more
  int num_drags = 0;           // so far: each has a name of its own
  // A field of the timeline's range while it is dragged.
  struct EditedRange {
    std::optional<int> frame;
    bool is_first = false;
  } edited_range;
  SheetPopup popup = SheetPopup::kNone;  // to be opened
};

}  // namespace hazumi::ui
