#pragma once

// Inverse kinematics for posing: a joint is dragged somewhere, within the limits.

#include <optional>
#include <vector>

#include "engine/figure/figure.h"
#include "engine/spatial/pose.h"
#include "engine/spatial/types.h"

namespace hazumi {

struct ReachProblem {
  Pose X_WR;                       // root in the world
  JointIndex moved;                // whose origin shall be at the target
  Vec3 target = Vec3::Zero();      // in the world [m]
  std::vector<JointIndex> hinges;  // that may turn; those not between root and `moved` do nothing
  // Of the body that `moved` sits on, in the world; not given: any.
  std::optional<Mat3> orientation = std::nullopt;
};

// Minimises the distance between the joint's origin and the target over the angles of the hinges,
// each within its limits: damped least squares from the pose `q` (by JointIndex [rad]), so that
// the nearest pose is found and small moves of the target give small moves of the pose. Where an
// orientation is given but cannot be had, it gives way to the place. A straight limb is bent
// towards the middle of its limits. Replaces the hinges' angles in `q`; returns the distance that
// is left [m]. Depends on the arguments alone.
double Reach(const Figure& figure, const ReachProblem& problem, VecX* q);

}  // namespace hazumi
