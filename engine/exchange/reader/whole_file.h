#pragma once

#include <string>

#include "engine/base/result.h"

namespace hazumi {

inline constexpr size_t kLongestFile = 512u << 20;  // that is read [bytes]

// The first bytes of a regular file, at most `most`. Error (kNoInput): why not.
Result<std::string> FileBeginning(const std::string& path, size_t most);
// All of it. Error also if it is longer than `most`.
Result<std::string> WholeFile(const std::string& path, size_t most);

}  // namespace hazumi
