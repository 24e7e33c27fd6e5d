#pragma once

#include "engine/analysis/effort.h"
#include "tests/support/animations.h"

namespace hazumi::test {

// A motion, and what it asks of muscles.
struct BakedEffort {
  Motion motion;
  Effort effort;
};

inline BakedEffort BakeEffort(const Animation& animation) {
  BakeOptions options;
  options.accelerations = true;
  BakedEffort found{BakeOrFail(animation, options), {}};
  found.effort = EffortOf(animation, found.motion);
  return found;
}

}  // namespace hazumi::test
