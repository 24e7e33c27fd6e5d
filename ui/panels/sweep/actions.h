#pragma once

#include "ui/panels/commands/actions.h"

namespace hazumi::ui {

// Looking at the cells of a sweep: each gives the project its values while it is chosen, as a drag
// does, and one is kept or none.
std::vector<Action> SweepActions();

}  // namespace hazumi::ui
