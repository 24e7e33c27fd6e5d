#pragma once

#include <string>

namespace hazumi {

// Canonical path: absolute, links followed as far as the path exists.
std::string FollowLinks(const std::string& path);

// True if the file lies in the folder or below it, links followed. False if either does not exist.
bool LiesIn(const std::string& file, const std::string& folder);

}  // namespace hazumi
