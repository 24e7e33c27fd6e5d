#pragma once

// Accelerations of a motion whose bake did not report them.

#include "engine/bake/motion.h"

namespace hazumi {

// Returns the right-sided accelerations at a frame; at the last frame the left-sided ones. The
// accelerations are those of cubics through the angles and rates of two frames. They are exact
// where keys make the motion and each frame is a frame of the project; elsewhere their error is
// proportional to the square of the frame time. A motion of one frame has zero accelerations.
MotionAcceleration AccelerationAt(const Motion& motion, size_t frame);

}  // namespace hazumi
