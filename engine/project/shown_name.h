#pragma once

#include <string>

namespace hazumi {

// What a project is called where it is shown: its name or, if nobody gave it one, that of its file
// without the suffix. A new project is called "Untitled".
std::string ShownName(const std::string& name, const std::string& file);

}  // namespace hazumi
