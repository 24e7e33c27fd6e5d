#pragma once

#include <tuple>

#include "engine/region/forces/force_law.h"

namespace hazumi {

class Attraction;
struct AttractionSpec {
  using Law = Attraction;
  static constexpr bool kIsOuter = true;  // as its law says
  int node = 0;                           // that it acts on
  Vec3 point = Vec3::Zero();              // in the node's frame [m]
  Vec3 to = Vec3::Zero();                 // in the world [m]
  double force = 0.0;                     // [N]
  double radius = 1.0;                    // [m]
};
inline auto MembersOf(const AttractionSpec& spec) {
  const auto& [node, point, to, force, radius] = spec;
  return std::tie(node, point, to, force, radius);
}

// A pull towards a place in the world. [METHOD 9.2]
class Attraction : public ForceLaw {
 public:
  explicit Attraction(const AttractionSpec& spec) : spec_(spec) {}

  std::string_view name() const override { return "attraction"; }
  bool is_outer() const override { return true; }
  void AddForces(const RegionState& state, NodeKinematics* kinematics) const override;
  bool has_kinks() const override { return true; }
  // Outside the radius it is above zero.
  void AppendKinks(const RegionState& state, std::vector<double>* kinks) const override;

 private:
  AttractionSpec spec_;
};

}  // namespace hazumi
