#pragma once

#include <string>

namespace hazumi {

// The manual page hazumi(1), in the macros of man(7), from the table of options.
std::string ManPage();

}  // namespace hazumi
