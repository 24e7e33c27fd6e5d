#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace hazumi {

// The text with control characters and malformed UTF-8 written out as \x1b, so that a name in a
// file cannot steer the terminal.
std::string Printable(std::string_view text);

// Prints one line, made as by printf and then Printable.
[[gnu::format(printf, 2, 3)]] void PrintLine(std::FILE* stream, const char* format, ...);

// Prints "hazumi: MESSAGE" and where to find help to standard error. Returns kExitUsage.
int ComplainOfUsage(const std::string& message);

}  // namespace hazumi
