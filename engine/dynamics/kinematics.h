#pragma once

#include "engine/dynamics/workspace.h"
#include "engine/figure/figure.h"
#include "engine/spatial/pose.h"

namespace hazumi {

// Motion of the root body in the world: twist and its time derivative, at the root's origin.
struct RootMotion {
  Vec3 w = Vec3::Zero();      // angular velocity [rad/s]
  Vec3 v = Vec3::Zero();      // velocity [m/s]
  Vec3 alpha = Vec3::Zero();  // angular acceleration [rad/s^2]
  Vec3 a = Vec3::Zero();      // acceleration [m/s^2]
  bool operator==(const RootMotion&) const = default;
};

// Places every body: fills R, p, axis, c. q: N angles [rad]. [Arai 2.1]
void ComputePositions(const Figure& figure, const Pose& X_WR, const VecX& q, DynamicsWorkspace* ws);

// Fills w, v, alpha, a from rates qd [rad/s] and accelerations qdd [rad/s^2]. Needs
// ComputePositions.
void ComputeMotion(const Figure& figure, const RootMotion& root, const VecX& qd, const VecX& qdd,
                   DynamicsWorkspace* ws);

// The rates alone: fills w and v.
void ComputeVelocities(const Figure& figure, const Vec3& w_root, const Vec3& v_root, const VecX& qd,
                       DynamicsWorkspace* ws);

// Positions and motion of the bodies from the root to that of joint `tip` alone.
void ComputeMotionTo(JointIndex tip, const Figure& figure, const Pose& X_WR, const RootMotion& root,
                     const VecX& q, const VecX& qd, const VecX& qdd, DynamicsWorkspace* ws);

// Of the whole figure, in the world [m]; needs ComputePositions.
Vec3 CenterOfMass(const Figure& figure, const DynamicsWorkspace& ws);
// Its velocity [m/s]; needs ComputeVelocities or ComputeMotion.
Vec3 CenterOfMassVelocity(const Figure& figure, const DynamicsWorkspace& ws);
// Its acceleration [m/s^2]; needs ComputeMotion.
Vec3 CenterOfMassAcceleration(const Figure& figure, const DynamicsWorkspace& ws);

// Velocity of the origin of joint j for a unit rate of joint i [m/rad]: zero unless i lies between
// the root and j. Needs ComputePositions.
inline Vec3 OriginJacobian(const Figure& figure, const DynamicsWorkspace& ws, JointIndex j,
                           JointIndex i) {
  if (!figure.IsBeyond(j, i)) return Vec3::Zero();
  return ws.body(i).axis.cross(ws.body(j).p - ws.body(i).p);
}

}  // namespace hazumi
