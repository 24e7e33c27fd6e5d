#pragma once

#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/figure/figure_spec.h"

namespace hazumi {

// Reads a figure file. What it returns has been tried with BuildFigure. Errors as of LoadProject.
Result<FigureSpec> LoadFigure(const std::string& path);

// The same from text. `file_name` is named in errors.
Result<FigureSpec> ParseFigure(std::string_view text, const std::string& file_name);

}  // namespace hazumi
