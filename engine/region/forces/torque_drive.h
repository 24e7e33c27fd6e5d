#pragma once

#include <tuple>
#include <utility>
#include <vector>

#include "engine/region/forces/force_law.h"

namespace hazumi {

class TorqueDrive;
struct TorqueSpec {
  using Law = TorqueDrive;
  static constexpr bool kIsOuter = false;
  std::vector<char> is_driven;  // by free hinge
};
inline auto MembersOf(const TorqueSpec& spec) {
  const auto& [is_driven] = spec;
  return std::tie(is_driven);
}

// Torques of hinges over time, DrivenMotion::drives. [METHOD 2.6]
class TorqueDrive : public ForceLaw {
 public:
  explicit TorqueDrive(TorqueSpec spec) : spec_(std::move(spec)) {}

  std::string_view name() const override { return "torque"; }
  void AddForces(const RegionState& state, NodeKinematics* kinematics) const override;

 private:
  small::V3 MomentOn(int node, const RegionState& state) const;

  TorqueSpec spec_;
};

}  // namespace hazumi
