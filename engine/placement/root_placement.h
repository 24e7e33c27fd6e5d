#pragma once

#include "engine/placement/figure_motion.h"

namespace hazumi {

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
