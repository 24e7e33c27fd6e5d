#pragma once

#include <string>

#include "engine/figure/figure_spec.h"

namespace hazumi {

// A figure as the text of a figure file, on one line; ParseFigure reads the same figure from it,
// but for rounding where joints are turned.
std::string FigureText(const FigureSpec& spec);

}  // namespace hazumi
