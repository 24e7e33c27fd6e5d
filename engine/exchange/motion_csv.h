#pragma once

#include <string>

#include "engine/bake/motion.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// A motion as a table, one row a frame: frame, time [s], root position [m] and quaternion (w x y
// z), CoM [m], pinned joint (or nothing), then angle [degrees] and rate [degrees/s] of every joint;
// with `torques` the torque of every joint [N m], and force [N] and moment [N m] that nothing
// supplies. With `effort` the same torques [N m], their shares of the strength (or nothing), and
// what comes from nowhere. All of it is that of analysis/effort.h.
std::string MotionToCsv(const Animation& animation, const Motion& motion, bool torques = false,
                        bool effort = false);

}  // namespace hazumi
