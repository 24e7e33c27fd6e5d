#pragma once

#include <vector>

#include "engine/analysis/held_turn.h"
#include "ui/panels/problems/problems.h"

namespace hazumi::ui {

// What of the project's regions holds the body where nothing could, or leaves a constraint alone:
// adds a problem for each turn of a root that keys hold, and each constraint that outlasts the
// regions that move its ends.
void AddRegionProblems(const std::vector<HeldTurn>& turns, edit::Session* session,
                       std::vector<Problem>* problems);
bool AnyOutlasts(const Animation& animation);

}  // namespace hazumi::ui
