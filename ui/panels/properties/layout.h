#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/project/project.h"
#include "engine/timeline/animation.h"
#include "ui/panels/properties/state.h"
#include "ui/panels/window/geometry.h"

namespace hazumi::ui {

// The tabs along the left edge, one a section, and the rest of the panel.
struct PropertiesLayout {
  std::vector<Rect> tabs;  // by Section
  Rect content;
};
PropertiesLayout LayOutProperties(const Rect& panel, double scale);
std::optional<Section> TabAt(const PropertiesLayout& layout, Point p);

// A row's parts: label, field, and a square for a button.
struct RowParts {
  Rect label, field, button;
};
// `text`: the label's width. One that is wider than its column takes room from the field, and where
// that would leave too little of it the field is a line below.
RowParts PartsOfRow(const Rect& row, float text, bool has_button, double scale);

// The joint that is shown: the one that was clicked last if any of it is selected, else the first
// selected one; none if nothing is.
std::optional<GroupIndex> ActiveJoint(const Figure& figure, const std::set<std::string>& selected,
                                      const std::string& active);

// The region that is shown: the chosen one if there is one, else the first that is active at the
// frame, else the first. By index; none if there are no regions.
std::optional<size_t> ShownRegion(const Project& project, ItemId chosen, double frame);

// What was solved, in words: "14 of 37 joints, 2 groups of 7, 6 bodies".
std::string ModelText(const RegionReport& report);

// The joints of a region as its operators take them, "+" behind a name for all beyond it.
std::vector<std::string> NamesOf(const std::vector<JointRef>& joints);
// `joints` and what is selected beside them; a joint of which all hinges are selected by its name.
std::vector<std::string> WithSelected(const std::vector<std::string>& joints, const Figure& figure,
                                      const std::set<std::string>& selected);

// Source of a value at a frame, shown as the colour of its field.
enum class FieldState {
  kPlain,         // nothing animates it
  kKeyed,         // a key on the frame
  kInterpolated,  // keys on other frames
  kChanged,       // a key on the frame, but something else moved it away, such as a hold
  kComputed       // by a dynamics region
};

// `curve`: null if there is none. `shown`: the value as it is at the frame, in the curve's units.
// `is_computed`: by a region, see edit::IsSwung.
FieldState StateOfField(const ProjectCurve* curve, double frame, double shown, bool is_computed);

}  // namespace hazumi::ui
