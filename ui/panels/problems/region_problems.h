#pragma once

#include <vector>

#include "engine/analysis/held_turn.h"
#include "ui/panels/problems/problems.h"

namespace hazumi::ui {

// Adds a problem for each region whose root orientation keys hold, and for each constraint that
// outlasts the regions that move its ends.
void AddRegionProblems(const std::vector<HeldTurn>& turns, edit::Session* session,
                       std::vector<Problem>* problems);
bool AnyOutlasts(const Animation& animation);

}  // namespace hazumi::ui
