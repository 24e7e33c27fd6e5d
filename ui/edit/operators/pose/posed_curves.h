#pragma once

// Internal: what operators that pose a figure have in common.

#include <string>
#include <vector>

#include "ui/edit/session/session.h"

namespace hazumi::edit {

// The curves of what is selected; of all hinges if nothing is.
std::vector<std::string> PosedCurves(const Session& session);

// The angle [degrees], within its hinge's limits; of the root's curves the value as it is.
double WithinLimits(const std::string& curve, double value, const Figure& figure);

// The parameter "share", 1 if it is not given. Errors: it is out of its range.
Result<double> ShareIn(const Parameters& p, const NumberRange& range);

}  // namespace hazumi::edit
