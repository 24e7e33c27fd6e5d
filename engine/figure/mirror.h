#pragma once

#include "engine/figure/figure_spec.h"

namespace hazumi {

// The specification with every joint whose name begins with `mirror->from` followed by its twin.
FigureSpec WithMirroredTwins(const FigureSpec& spec);

}  // namespace hazumi
