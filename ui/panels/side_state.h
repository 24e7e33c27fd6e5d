#pragma once

#include <set>
#include <string>

namespace hazumi::ui {

// The outliner and the properties.
struct SideState {
  std::string search;            // of joints
  std::set<std::string> closed;  // groups whose joints are not shown
};

}  // namespace hazumi::ui
