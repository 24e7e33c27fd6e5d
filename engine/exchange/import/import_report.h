#pragma once

#include <cstddef>
#include <vector>

#include "engine/base/warning.h"

namespace hazumi {

inline constexpr size_t kShortReport = 10;

// Warnings that say the same of several places become one that names them; of more than `most` the
// rest is counted. 0: all of them, as they are.
std::vector<Warning> Shortened(const std::vector<Warning>& warnings, size_t most);

}  // namespace hazumi
