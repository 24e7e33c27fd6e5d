#pragma once

#include <string>

#include "engine/bake/motion.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Motion as a table, one row per frame: frame, time [s], root position [m] and quaternion (w x y
// z), CoM [m], pinned joint (or nothing), then angle [degrees] and rate [degrees/s] of every joint.
// `torques` adds the torque of every joint [N m], and the residual force [N] and moment [N m].
// `effort` adds the same torques [N m], their shares of the strength (or nothing), and the residual
// wrench. analysis/effort.h computes all of them.
std::string MotionToCsv(const Animation& animation, const Motion& motion, bool torques = false,
                        bool effort = false);

}  // namespace hazumi
