#pragma once

#include "engine/figure/link_surface.h"

namespace hazumi {

// Lift and drag of a surface at an angle to the flow, 0 to 90 degrees [rad].
struct AirCoefficients {
  double lift = 0.0, drag = 0.0;
};
AirCoefficients CoefficientsOf(const LinkSurface& surface, double angle);

// What air of a density [kg/m^3] that moves with u [m/s], relative to it, does to a surface of unit
// normal n [N]. n and u in one frame. [METHOD 9.1]
Vec3 AirOnSurface(const LinkSurface& surface, double density, const Vec3& n, const Vec3& u);

}  // namespace hazumi
