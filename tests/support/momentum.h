#pragma once

#include "engine/bake/motion.h"
#include "engine/figure/figure.h"

namespace hazumi::test {

// What a figure that nothing touches keeps.
struct Momentum {
  Vec3 com, com_v;  // [m, m/s]
  Vec3 L;           // angular momentum about the CoM, world axes [kg m^2/s]
  double kinetic;   // [J]
  double potential(double gravity) const { return mass * gravity * com.z(); }
  double mass;
};

Momentum MomentumOf(const Figure& figure, const MotionLimit& motion);

}  // namespace hazumi::test
