#pragma once

// A figure as a file of its own: read, and written.

#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/warning.h"
#include "engine/figure/figure_spec.h"

namespace hazumi {

// Reads a figure file and validates it with BuildFigure. Errors as of LoadProject. `warnings`
// receives warnings, `unknown` the unknown fields.
Result<FigureSpec> LoadFigure(const std::string& path, std::vector<Warning>* warnings = nullptr,
                              std::vector<Warning>* unknown = nullptr);

// The same from text. `file_name` is named in errors.
Result<FigureSpec> ParseFigure(std::string_view text, const std::string& file_name,
                               std::vector<Warning>* warnings = nullptr,
                               std::vector<Warning>* unknown = nullptr);

// A figure as the text of a figure file, on one line; ParseFigure reads the same figure from it,
// but for rounding where joints are turned.
std::string FigureText(const FigureSpec& spec);

// The human that comes with Hazumi: assets/figures/human.json.
const FigureSpec& HumanFigure();

}  // namespace hazumi
