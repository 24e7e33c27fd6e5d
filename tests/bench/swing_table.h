#pragma once

#include "tests/bench/swing_method.h"

namespace hazumi::bench {

inline constexpr char kSwingColumns[] =
    "subject,case,setting,microseconds,error_rad,set_up_microseconds";
// The rows of a case, by all methods that handle it, and of its reference.
void PrintSwings(const SwingCase& c, const std::vector<SwingMethod>& methods, int rounds);

}  // namespace hazumi::bench
