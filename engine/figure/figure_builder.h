#pragma once

#include "engine/base/result.h"
#include "engine/figure/figure.h"
#include "engine/figure/figure_spec.h"

namespace hazumi {

// The specification with every joint whose name begins with `mirror->from` followed by its twin.
FigureSpec WithMirroredTwins(const FigureSpec& spec);

// Checks the specification and builds the figure: numbers the joints depth first (children in the
// order of the file), adds the mirrored twins, sums the inertias. Errors are ErrorCode::kSchema
// with a place such as `joints[3].hinges[0].axis`, relative to the figure.
Result<Figure> BuildFigure(const FigureSpec& spec);

}  // namespace hazumi
