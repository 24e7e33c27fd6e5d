#pragma once

#include "ui/panels/commands/actions.h"

namespace hazumi::ui {

// Looking at the cells of a sweep: each gives the project its values while it is chosen, as a drag
// does, and one is kept or none.
std::vector<Action> SweepActions();
// "friction.default" of "regions[arms].friction.default": what tells columns apart.
std::string ShortName(const std::string& name);
// Closes a sweep that was opened for a document that is no longer there, and says so.
void CloseSweepOfOther(Editor* editor);
// Whether the project still has the values of the cell that was kept last.
bool HasKeptCell(const Editor& editor);

}  // namespace hazumi::ui
