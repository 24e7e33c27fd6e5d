#pragma once

// Motion of a limb between poses with the least
//
//   sum over frames  w_t^2 |tau'|^2 + w_a^2 |alpha|^2 + w_v^2 |omega - omega_ref|^2
//                    + over frames at which the joint is known  w_s^2 |omega|^2
//                    + over given rates  w_r^2 (along . omega - rate)^2,  w_r = 1000 / s
//
// tau' [rad/s^2]: the torques that its joints give, each joint's divided by the Cholesky factor of
// the inertia that it carries and by the root of the first joint's mean one. alpha [rad/s^2]:
// angular acceleration of a joint against the body before it; omega [rad/s] its angular velocity,
// omega_ref that of a reference. Frames are transcribed directly: a joint's turn on each frame on
// which it is not known is unknown. Gauss and Newton's method, damped as Levenberg does.

#include <optional>

#include "engine/solve/chain.h"
#include "engine/solve/least_squares.h"

namespace hazumi::solve {

struct FillWeights {
  double torque = 1.0;        // w_t
  double acceleration = 0.4;  // w_a
  double velocity = 8.0;      // w_v [1/s]
  double standing = 0.0;      // w_s [1/s]
};

// Replaces the turns that are not known. They are the start, and the reference of the velocity.
SquaresReport SolveFill(const Chain& chain, const FillWeights& weights, Turns* turns);

// Same with the accelerations alone: the spline of least acceleration in the space of
// rotations, joint by joint. It asks for no masses.
SquaresReport SolveSpline(const Chain& chain, Turns* turns);

}  // namespace hazumi::solve
