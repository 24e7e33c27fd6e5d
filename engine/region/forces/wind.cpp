// Cylinders. With u the air's velocity relative to a point of the axis, u_n what of it is across
// the axis, each length ds of the axis feels
//   dF = rho C_D d |u_n| u_n ds / 2,   C_D = 1.1,
// summed over Gauss's points. Their ends are left out. Surfaces: air_on_surface.cpp.

#include "engine/region/forces/wind.h"

#include <cmath>

namespace hazumi {

using namespace small;  // NOLINT(google-build-using-namespace): operators

namespace {

// Across a cylinder of any length, for the speeds of limbs [Hoerner 1965].
constexpr double kCrossFlowDrag = 1.1;

// Gauss's formula of order 12, on either side of the middle; weights of an interval of length 1.
constexpr int kPairs = 3;
constexpr double kPoint[kPairs] = {0.2386191860831969, 0.6612093864662645, 0.9324695142031521};
constexpr double kWeight[kPairs] = {0.2339569672863455, 0.1803807865240693, 0.08566224618958517};

}  // namespace

void Wind::AddForces(const RegionState& state, NodeKinematics* kinematics) const {
  for (const AirCylinder& cylinder : spec_.cylinders) AddDrag(cylinder, state, kinematics);
  for (const auto& [node, surface] : spec_.surfaces) {
    const M3& R = kinematics->motion()[node].R;
    const V3 r = R * V3(surface.center);
    const Vec3 n = (R * V3(surface.normal)).eigen();
    const Vec3 u = spec_.velocity - state.VelocityAt(node, r).eigen();
    kinematics->AddForce(node, r, V3(AirOnSurface(surface, spec_.density, n, u)));
  }
}

void Wind::AddDrag(const AirCylinder& cylinder, const RegionState& state,
                   NodeKinematics* kinematics) const {
  const M3& R = kinematics->motion()[cylinder.node].R;
  const V3 middle = R * V3(0.5 * (cylinder.a + cylinder.b));
  const V3 half = R * V3(0.5 * (cylinder.b - cylinder.a));
  const double square = Dot(half, half);
  if (square == 0.0) return;
  const double length = 2.0 * std::sqrt(square);
  const double scale = 0.5 * spec_.density * kCrossFlowDrag * cylinder.diameter * length;
  for (const double side : {-1.0, 1.0}) {
    for (int i = 0; i < kPairs; ++i) {
      const V3 r = middle + (side * kPoint[i]) * half;
      const V3 u = V3(spec_.velocity) - state.VelocityAt(cylinder.node, r);
      const V3 across = u - (Dot(u, half) / square) * half;
      const double speed = std::sqrt(Dot(across, across));
      kinematics->AddForce(cylinder.node, r, (scale * kWeight[i] * speed) * across);
    }
  }
}

}  // namespace hazumi
