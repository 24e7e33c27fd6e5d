#include "engine/region/region_laws.h"

#include <algorithm>
#include <utility>

#include "engine/region/contact/step_forces.h"
#include "engine/region/free_bodies.h"

namespace hazumi {

RegionLaws::RegionLaws(ForceLaws laws) : laws_(std::move(laws)) {
  for (const auto& law : laws_) {
    (law->is_rule() ? any_rules_ : any_forces_) = true;
    any_outer_ |= law->is_outer();
    any_springs_ |= law->is_spring();
    any_kinks_ |= law->has_kinks();
    any_other_kinks_ |= law->has_kinks() && !law->is_spring();
  }
}

double RegionLaws::FastestRate() const {
  double rate = 0.0;
  for (const auto& law : laws_) rate = std::max(rate, law->FastestRate());
  return rate;
}

LoadedState RegionLaws::Load(const RegionState& state, const StepForces& constant,
                             const FreeBodies& bodies, NodeKinematics* nodes) const {
  constant.AddTo(nodes);
  bodies.Accelerate(nodes);
  if (any_forces_) {
    constant.AddSpringsTo(nodes);
    for (const auto& law : laws_) {
      if (!constant.holds_springs || !law->is_spring()) law->AddForces(state, nodes);
    }
  }
  return {state, nodes};
}

void RegionLaws::AddForces(const ForceLaw& law, const RegionState& state,
                           const StepForces& constant, NodeKinematics* nodes) {
  if (constant.holds_springs && law.is_spring()) {
    constant.AddSpringsTo(nodes);
  } else {
    law.AddForces(state, nodes);
  }
}

void RegionLaws::FindKinks(const RegionState& state, bool with_springs,
                           std::vector<double>* kinks) const {
  kinks->clear();
  for (const auto& law : laws_) {
    if (with_springs || !law->is_spring()) law->AppendKinks(state, kinks);
  }
}

std::vector<JointSpring> RegionLaws::Springs(const RegionState& state) const {
  std::vector<JointSpring> springs;
  for (const auto& law : laws_) law->ListSprings(state, &springs);
  return springs;
}

Vec3 RegionLaws::LimitSprings(const RegionState& state, int node, Vec3 moment) const {
  for (const auto& law : laws_) {
    if (law->is_spring()) moment = law->Limit(state, node, moment);
  }
  return moment;
}

std::vector<SpentDrive> RegionLaws::Spent(const RegionState& state) const {
  std::vector<SpentDrive> spent;
  for (const auto& law : laws_) law->ListSpent(state, &spent);
  return spent;
}

}  // namespace hazumi
