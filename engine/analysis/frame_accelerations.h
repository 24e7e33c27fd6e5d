#pragma once

// Accelerations of a motion whose bake did not tell them.

#include "engine/bake/motion.h"

namespace hazumi {

// Those after a frame, of the last one those before it, of cubics through angles and rates of two
// frames: exact where keys make the motion and each frame is a frame of the project, else with an
// error that goes with the square of the frame time. A motion of one frame is at rest there.
MotionAcceleration AccelerationAt(const Motion& motion, size_t frame);

}  // namespace hazumi
