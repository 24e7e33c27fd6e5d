#pragma once

// A figure at one instant, and where its root is put.

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

// Orientation R = Rz(z) Ry(y) Rx(x) of a root whose three hinge angles are given as value, rate and
// acceleration; sets motion->X_WR.R and the angular parts of motion->root.
struct RootAngles {
  double angle[3], rate[3], acceleration[3];  // z, y, x [rad]
};
void SetRootOrientation(const RootAngles& angles, FigureMotion* motion);

// Moves the root so that the origin of `pin` is at `p_W` and at rest [Arai 3.1]. Joint angles and
// root orientation stay. The workspace is filled from the root to the pin.
void PinRoot(const Figure& figure, JointIndex pin, const Vec3& p_W, DynamicsWorkspace* ws,
             FigureMotion* motion);

// Moves the root so that the figure's CoM is at `com` [m] with velocity `com_v` [m/s], falling
// freely [Arai 3.2 (2)].
void PlaceCenterOfMass(const Figure& figure, const Vec3& com, const Vec3& com_v,
                       DynamicsWorkspace* ws, FigureMotion* motion);

}  // namespace hazumi
