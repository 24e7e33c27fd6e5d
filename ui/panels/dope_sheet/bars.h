#pragma once

#include <optional>
#include <string>

#include "ui/panels/window/editor.h"

namespace hazumi::ui {

// What bars of the dope sheet stand for, whatever kind they are of.

// First and last frame, half open.
ProjectFrames FramesOf(const Project& project, const BarRef& bar);
// What a bar is called: "arms", "pinned: l_toe", "gravity", "held: l_wrist".
std::string TitleOf(const Project& project, const BarRef& bar);
// What there is no room for in the bar; empty if nothing.
std::string DetailsOf(const Project& project, const BarRef& bar);

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
