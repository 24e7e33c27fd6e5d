#pragma once

#include <tuple>
#include <vector>

#include "engine/spatial/types.h"

namespace hazumi {

// A thin flat face of a link, which air presses on: a hand, a sail, a wing.
struct LinkSurface {
  // How its lift and drag depend on the angle between it and the flow.
  enum class Kind { kPlate, kWing, kTable };

  double area = 0.0;            // [m^2], of one side
  Vec3 normal = Vec3::UnitX();  // unit
  Vec3 center = Vec3::Zero();   // where the air presses [m]
  Kind kind = Kind::kPlate;
  // kTable: coefficients at equal steps of the angle from 0 to 90 degrees; one: the same at any.
  std::vector<double> lift, drag;
  bool is_faded = true;  // fades the lift next to 0 and 90 degrees
};
inline auto MembersOf(const LinkSurface& surface) {
  const auto& [area, normal, center, kind, lift, drag, is_faded] = surface;
  return std::tie(area, normal, center, kind, lift, drag, is_faded);
}

}  // namespace hazumi
