#pragma once

#include <string>

#include "engine/bake/motion.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// A motion as a table, one row a frame: frame, time [s], root position [m] and quaternion (w x y
// z), CoM [m], pinned joint (or nothing), then angle [degrees] and rate [degrees/s] of every joint.
std::string MotionToCsv(const Animation& animation, const Motion& motion);

}  // namespace hazumi
