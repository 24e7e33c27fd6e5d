#pragma once

// What a swing without friction keeps.

#include "engine/bake/motion.h"
#include "engine/figure/figure.h"

namespace hazumi::test {

// Mechanical energy of a figure on a root that stands still at the world's origin, gravity along -z
// [m/s^2], heights from the origin [J].
double EnergyOf(const Figure& figure, const VecX& q, const VecX& qd, double gravity);
// And on a root that moves.
double EnergyOf(const Figure& figure, const MotionLimit& state, double gravity);

// What energies are to be compared with: the kinetic energy of the state, and the work of gravity
// as the figure's bodies fall by their distance from the root [J].
double EnergyScale(const Figure& figure, const VecX& q, const VecX& qd, double gravity);

}  // namespace hazumi::test
