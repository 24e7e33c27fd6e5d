#pragma once

// The torques that a motion needs, by inverse dynamics of every frame.

#include <vector>

#include "engine/bake/motion.h"
#include "engine/timeline/animation.h"

namespace hazumi {

struct JointTorques {
  VecX tau;  // by JointIndex, about the hinge's axis, on the body beyond it [N m]
  // What the motion needs beyond gravity, inertia and the pin: on the root, at its origin, world
  // axes. Zero on a pin. In a flight the force is zero but for the error of the accelerations; a
  // moment is what keys need that turn the figure in the air. Elsewhere the ground would have to
  // give it, or nothing could, and legs lack the torques of the ground's force.
  Wrench unsupported;
};

// Accelerations after a frame, of the last one those before it, as TorquesOf has them.
MotionAcceleration AccelerationAt(const Motion& motion, size_t frame);

// One entry a frame of the motion; what is held counts as part of its holder's body. Accelerations
// are those after a frame, of the last one those before, of cubics through angles and rates of two
// frames: exact where keys make the motion and each frame is a frame of the project, else with an
// error that goes with the square of the frame time. A motion of one frame is at rest there.
std::vector<JointTorques> TorquesOf(const Animation& animation, const Motion& motion);

}  // namespace hazumi
