#pragma once

#include <optional>
#include <string>

#include "engine/project/checks/checks.h"
#include "engine/timeline/animation.h"

namespace hazumi::testing {

// What contradicts what in an animation, found in the plain way: each region, placement and hold is
// compared with each other one, in the order in which they are reported.
struct Contradiction {
  Check check;
  std::string place;
};
std::optional<Contradiction> FirstContradiction(const Animation& animation);

}  // namespace hazumi::testing
