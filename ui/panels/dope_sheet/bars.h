#pragma once

#include <optional>
#include <string>

#include "ui/panels/dope_sheet/bar_types.h"

namespace hazumi::ui {

// Bars of the dope sheet, whatever kind they are of.

// First and last frame, half open.
ProjectFrames FramesOf(const Project& project, const BarRef& bar);
// Title of a bar: "arms", "pinned: l_toe", "gravity", "held: l_wrist".
std::string TitleOf(const Project& project, const BarRef& bar);
// Sentences that the bar has no room for; empty: none.
std::string DetailsOf(const Project& project, const BarRef& bar);

// None: what it stands for is not there, or its kind has no bars.
std::optional<BarRef> FindBar(const Project& project, const BarId& bar);
// The bar that was clicked last, if what it stands for is still there.
std::optional<BarRef> ChosenBar(const Project& project, const SheetState& sheet);
BarId IdOf(const Project& project, const BarRef& bar);
void ChooseBar(Editor* editor, const BarRef& bar);  // the properties show a region, too
void ChooseNoBar(SheetState* sheet);

// Run the operator of its kind on the chosen bar, which stays chosen. `change`: what its operator
// takes, "first" and "last" whatever the kind.
Result<Done> EditChosenBar(Editor* editor, Json change);
Result<Done> RemoveChosenBar(Editor* editor);

}  // namespace hazumi::ui
