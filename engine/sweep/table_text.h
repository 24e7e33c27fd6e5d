#pragma once

// A table as text: lines of comma-separated values, and numbers as they are shown.

#include <string>
#include <string_view>
#include <vector>

namespace hazumi {

// Comma-separated values, as of RFC 4180: fields with a comma, a quote or a line end stand in
// quotes, and a quote in them is doubled. Lines end with "\n".
std::string CsvLine(const std::vector<std::string>& fields);

// Lines may also end with "\r\n"; the last one may have no end.
std::vector<std::vector<std::string>> ReadCsv(std::string_view text);

// A text that is a number with so many significant digits, and never fewer than stand before the
// point; any other text as it is.
std::string ShortDecimal(const std::string& text, int digits = 3);
// Three digits each, or as many as it takes to tell neighbours apart that differ.
std::vector<std::string> ShortDecimals(const std::vector<std::string>& texts);

}  // namespace hazumi
