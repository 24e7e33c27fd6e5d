#pragma once

// Internal: what operators that pose a figure share: curves, a share, the other side.

#include <string>
#include <vector>

#include "engine/base/result.h"
#include "ui/edit/session/session.h"

namespace hazumi::edit {

// The curves of what is selected; of all hinges if nothing is.
std::vector<std::string> PosedCurves(const Session& session);

// The angle [degrees], within its hinge's limits; of the root's curves the value as it is.
double WithinLimits(const std::string& curve, double value, const Figure& figure);

// The parameter "share", 1 if it is not given. Errors: it is out of its range.
Result<double> ShareIn(const Parameters& p, const NumberRange& range);

// The mirror image of a pose, left for right: of what is in it, root and joints. A joint whose
// hinges are not those of its partner the other way round turns its partner as a whole, as nearly
// as that can; the angles are those nearest to the ones it has at the current frame.
// Errors: of Session::ValueNow.
Result<Pose> Flipped(const Pose& pose, Session* session);

// Of operators that pose one side.
inline constexpr ParameterInfo kMirror = {"mirror", ParameterKind::kYesNo, false,
                                          "true: the other side too, as the mirror image"};
// The pose, and if `mirror` is asked for the mirror image of what it leaves out of the other side.
Result<Pose> PoseOfSides(Pose pose, const Parameters& p, Session* session);

}  // namespace hazumi::edit
