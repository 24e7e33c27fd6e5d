#pragma once

#include <vector>

#include "engine/placement/figure_motion.h"

namespace hazumi {

// All rotations of a figure, by Coordinate: N hinges, then the root's about z, y, x. And what moves
// beside it.
struct RotationState {
  VecX q, qd;          // [rad, rad/s]
  PointMotion anchor;  // of the pin or, in flight, of the centre of mass
  std::vector<LooseObject> loose = {};
  Vec3 pin_velocity = Vec3::Zero();  // of a pin that is stopped here [m/s]
};

}  // namespace hazumi
