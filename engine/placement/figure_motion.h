#pragma once

#include "engine/dynamics/kinematics.h"

namespace hazumi {

// The whole figure at one instant.
struct FigureMotion {
  double frame = 0.0;
  VecX q, qd, qdd;  // all joints [rad, rad/s, rad/s^2]; qdd is 0 for joints of a dynamics region
  Pose X_WR;        // root in the world
  RootMotion root;
  bool operator==(const FigureMotion&) const = default;
};

}  // namespace hazumi
