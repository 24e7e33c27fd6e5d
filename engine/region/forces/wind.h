#pragma once

#include <tuple>
#include <utility>
#include <vector>

#include "engine/figure/link_surface.h"
#include "engine/region/forces/force_law.h"

namespace hazumi {

// The round part of a capsule, across which air flows.
struct AirCylinder {
  int node = 0;
  Vec3 a = Vec3::Zero(), b = Vec3::Zero();  // ends of its axis, in the node's frame [m]
  double diameter = 0.0;                    // [m]
};
inline auto MembersOf(const AirCylinder& cylinder) {
  const auto& [node, a, b, diameter] = cylinder;
  return std::tie(node, a, b, diameter);
}

struct AirSurface {
  int node = 0;
  LinkSurface surface;  // in the node's frame
};
inline auto MembersOf(const AirSurface& on) {
  const auto& [node, surface] = on;
  return std::tie(node, surface);
}

class Wind;
struct WindSpec {
  using Law = Wind;
  static constexpr bool kIsOuter = true;  // as its law says
  Vec3 velocity = Vec3::Zero();           // of the air, in the world [m/s]
  double density = 0.0;                   // [kg/m^3]
  std::vector<AirCylinder> cylinders;
  std::vector<AirSurface> surfaces;
};
inline auto MembersOf(const WindSpec& spec) {
  const auto& [velocity, density, cylinders, surfaces] = spec;
  return std::tie(velocity, density, cylinders, surfaces);
}

// What air does to bodies that it flows past. [METHOD 9.1]
class Wind : public ForceLaw {
 public:
  explicit Wind(WindSpec spec) : spec_(std::move(spec)) {}

  std::string_view name() const override { return "air"; }
  bool is_outer() const override { return true; }
  void AddForces(const RegionState& state, NodeKinematics* kinematics) const override;

 private:
  void AddDrag(const AirCylinder& cylinder, const RegionState& state,
               NodeKinematics* kinematics) const;

  WindSpec spec_;
};

// Lift and drag of a surface at an angle to the flow, 0 to 90 degrees [rad].
struct AirCoefficients {
  double lift = 0.0, drag = 0.0;
};
AirCoefficients CoefficientsOf(const LinkSurface& surface, double angle);

// Returns the force [N] of air of a density [kg/m^3] that moves with u [m/s], relative to a surface
// of unit normal n. n and u in one frame. [METHOD 9.1]
Vec3 AirOnSurface(const LinkSurface& surface, double density, const Vec3& n, const Vec3& u);

}  // namespace hazumi
