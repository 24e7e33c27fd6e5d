#pragma once

#include <string>

namespace hazumi::ui {

// What a factor of friction, the share of speed that is left after 1/30 s, means to the eye: when
// half of the speed is gone, and how much is left after a second.
std::string FrictionInWords(double factor);

}  // namespace hazumi::ui
