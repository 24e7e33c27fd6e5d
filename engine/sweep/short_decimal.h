#pragma once

#include <string>
#include <vector>

namespace hazumi {

// A text that is a number with so many significant digits, and never fewer than stand before the
// point; any other text as it is.
std::string ShortDecimal(const std::string& text, int digits = 3);
// Three digits each, or as many as it takes to tell neighbours apart that differ.
std::vector<std::string> ShortDecimals(const std::vector<std::string>& texts);

}  // namespace hazumi
