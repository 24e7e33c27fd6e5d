// With d the way from the point to the place:
//   F = f min(|d| / r, 1) d / |d|
// which is the gradient of -f (|d| - r / 2) outside the radius r, of -f d.d / (2 r) inside it.

#include "engine/region/forces/attraction.h"

#include <algorithm>

namespace hazumi {

void Attraction::AddForces(const RegionState& state, NodeKinematics* kinematics) const {
  const small::V3 r = kinematics->motion()[spec_.node].R * small::V3(spec_.point);
  const Vec3 d = spec_.to - state.PositionAt(spec_.node, r).eigen();
  kinematics->AddForce(spec_.node, r,
                       small::V3(spec_.force / std::max(d.norm(), spec_.radius) * d));
}

void Attraction::AppendKinks(const RegionState& state, std::vector<double>* kinks) const {
  const small::V3 r = state.kinematics.motion()[spec_.node].R * small::V3(spec_.point);
  const Vec3 d = spec_.to - state.PositionAt(spec_.node, r).eigen();
  kinks->push_back(d.norm() - spec_.radius);
}

}  // namespace hazumi
