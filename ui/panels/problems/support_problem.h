#pragma once

#include "engine/analysis/missing_support.h"
#include "ui/panels/problems/problems.h"

namespace hazumi::ui {

// Problem with the frames, the missing force or moment, and the remedy. Leads to the worst frame.
Problem SupportProblem(const MissingSupport& missing, const Figure& figure);

}  // namespace hazumi::ui
