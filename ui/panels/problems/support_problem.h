#pragma once

#include "engine/analysis/missing_support.h"
#include "ui/panels/problems/problems.h"

namespace hazumi::ui {

// When, what is lacking, and what to do, led to the worst frame.
Problem SupportProblem(const MissingSupport& missing, const Figure& figure);

}  // namespace hazumi::ui
