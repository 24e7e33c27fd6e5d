#pragma once

#include "engine/spatial/point_motion.h"

namespace hazumi {

// All rotations of a figure, by Coordinate: N hinges, then the root's about z, y, x.
struct RotationState {
  VecX q, qd;          // [rad, rad/s]
  PointMotion anchor;  // of the pin or, in flight, of the centre of mass
};

}  // namespace hazumi
