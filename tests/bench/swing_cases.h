#pragma once

#include "tests/bench/swing_method.h"

namespace hazumi::bench {

// arm7_smooth, free_swing, swing_with_limits, near_gimbal.
std::vector<SwingCase> SwingCases();

}  // namespace hazumi::bench
