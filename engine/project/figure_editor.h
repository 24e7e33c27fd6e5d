#pragma once

// Edits of a figure that is embedded in a project: of its JSON text, so that unknown fields stay,
// and of what was read from it. A mirrored side is edited by the side that it mirrors.

#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/project/project_figure.h"

namespace hazumi {

// What is not given stays as it is. All errors leave the figure as it was: kSchema if it is a file
// of its own, if there is no such part, or if no figure can be like that.

// Limits of a hinge [deg]. A rest angle outside of them is moved to the nearer one.
Result<Done> SetHingeLimits(const std::string& hinge, std::optional<double> lower,
                            std::optional<double> upper, ProjectFigure* figure);

// A stated inertia grows with the mass; a density gives way to it.
struct LinkChange {
  std::optional<double> mass_kg, radius_m;
};
Result<Done> ChangeLink(const std::string& link, const LinkChange& change, ProjectFigure* figure);

// Joints whose turn, hinges and role, and nothing else, become those of joints of the same names.
Result<Done> ReplaceHinges(const std::vector<JointSpec>& joints, ProjectFigure* figure);

// Takes the text of the figure's file, looked up in `folder`, into the project. Errors: of reading
// it; kSchema if it is embedded already.
Result<Done> EmbedFigure(const std::string& folder, ProjectFigure* figure);

}  // namespace hazumi
