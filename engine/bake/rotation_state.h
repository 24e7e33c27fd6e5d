#pragma once

#include "engine/spatial/types.h"

namespace hazumi {

// All rotations of a figure, by Coordinate: N hinges, then the root's about z, y, x.
struct RotationState {
  VecX q, qd;  // [rad, rad/s]
};

}  // namespace hazumi
