#pragma once

// Comma-separated values, as of RFC 4180: fields with a comma, a quote or a line end stand in
// quotes, and a quote in them is doubled. Lines end with "\n".

#include <string>
#include <string_view>
#include <vector>

namespace hazumi {

std::string CsvLine(const std::vector<std::string>& fields);

// Lines may also end with "\r\n"; the last one may have no end.
std::vector<std::vector<std::string>> ReadCsv(std::string_view text);

}  // namespace hazumi
