#pragma once

#include <optional>
#include <set>
#include <string>

#include "engine/project/item_id.h"

namespace hazumi::ui {

// What the properties show.
enum class Section { kPose, kPoses, kRegion, kScene, kProject, kProblems, kSweep };

// A number that is being typed into a field: it counts when it is confirmed.
struct TypedField {
  unsigned id = 0;  // ImGui's
  double value = 0.0;
};

// The outliner and the properties.
struct SideState {
  std::string search;            // of joints
  std::set<std::string> opened;  // joints whose hinges are shown
  std::set<std::string> closed;  // headings whose rows are not
  std::string anchor;            // the row that was clicked last; Shift+click selects from there
  std::string active;            // joint, root, object or camera that the properties show
  Section section = Section::kPose;
  ItemId region;        // that the properties show; if there is none, one at the frame
  ItemId shown_object;  // whose fields were opened last because it was selected
  ItemId added;         // a force or a constraint that is new: its fields are yet to be opened
  int drags = 0;        // so far, so that each has a name of its own
  std::optional<TypedField> typed;
};

}  // namespace hazumi::ui
