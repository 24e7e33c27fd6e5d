#pragma once

#include <vector>

#include "engine/bake/motion.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Beside a flight, where it stands on a pin before and after it, the figure is thrown forward or
// braked harder than legs can.
struct ContactJerk {
  int frame = 0;              // the hardest, of the animation's
  bool is_landing = false;    // else its take-off
  double acceleration = 0.0;  // of the centre of mass, horizontal [m/s^2]
};

// One for each take-off and landing at most, of flights by gravity from one pin to another. Of a
// motion at the animation's frame rate.
std::vector<ContactJerk> ContactJerks(const Animation& animation, const Motion& motion);

}  // namespace hazumi
