#pragma once

#include <set>
#include <string>
#include <vector>

#include "engine/figure/side_names.h"
#include "engine/project/items.h"
#include "ui/panels/properties/state.h"

namespace hazumi::ui {

enum class OutlinerRowKind { kHeading, kRoot, kJoint, kHinge, kItem, kCamera };

struct OutlinerRow {
  OutlinerRowKind kind;
  std::string name;   // as the document has it; of a heading as Tr takes it
  std::string label;  // what is shown: of a hinge what comes behind its joint's name
  int depth = 0;      // of indentation
  bool has_rows = false;
  bool is_open = false;
  BodySide side = BodySide::kMiddle;
  ItemId item = {};              // of kItem
  Thing thing = Thing::kObject;  // of kItem: its kind
};

// The root, a joint or a hinge: it can be selected with others, hidden and locked.
bool IsSelectable(const OutlinerRow& row);

// The rows from top to bottom: the figure, joint by joint from the root on, then items by kind and
// the camera. With a search text, those whose name has it in any case, and the joint or the heading
// above them.
std::vector<OutlinerRow> OutlinerRows(const Figure& figure, const Project& project,
                                      const SideState& state);

// Joints and hinges that are selected when a row is clicked.
enum class ClickMode { kOnly, kExtend, kToggle };
struct JointClick {
  std::vector<std::string> names;  // for select.joints
  const char* mode;                // "replace", "add" or "remove"
};
// `row` is selectable. Extended from the row named `anchor`; if it is not there, by
// this row alone.
JointClick ClickOn(const std::vector<OutlinerRow>& rows, size_t row, const std::string& anchor,
                   ClickMode click, const std::set<std::string>& selected, const Figure& figure);

// How many hinges of a joint, or whether the root, are among the names: of what is selected,
// hidden, locked.
enum class Share { kNone, kSome, kAll };
Share ShareOf(const OutlinerRow& row, const std::set<std::string>& names, const Figure& figure);

}  // namespace hazumi::ui
