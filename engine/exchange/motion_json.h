#pragma once

#include <string>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/timeline/animation.h"

namespace hazumi {

struct MotionJsonOptions {
  // Also write how long each region took. Off by default: it differs from run to run, and two bakes
  // of one file should be equal bytes.
  bool timings = false;
};

// A motion as JSON, one line a frame: metres, degrees, seconds, world axes (z up), quaternions
// w x y z. The fields are listed in README.md beside this file.
std::string MotionToJson(const Animation& animation, const Motion& motion,
                         const MotionJsonOptions& options = {});

}  // namespace hazumi
