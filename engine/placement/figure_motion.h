#pragma once

#include <optional>
#include <vector>

#include "engine/dynamics/kinematics.h"
#include "engine/spatial/body_motion.h"

namespace hazumi {

// A held object that was let go, and moves with what a region's links may touch.
struct LooseObject {
  int object = 0;  // by index of the animation's
  BodyMotion motion;
  bool operator==(const LooseObject&) const = default;
};

// The whole figure at one instant.
struct FigureMotion {
  double frame = 0.0;
  VecX q, qd, qdd;  // all joints [rad, rad/s, rad/s^2]; qdd is 0 for joints of a dynamics region
  Pose X_WR;        // root in the world
  RootMotion root;
  // Where forces from outside push a figure in flight off its parabola: its centre of mass.
  std::optional<PointMotion> fall;
  std::vector<int> broken;  // constraints that gave way, by index of the animation's
  std::vector<LooseObject> loose;
  bool operator==(const FigureMotion&) const = default;
};

}  // namespace hazumi
