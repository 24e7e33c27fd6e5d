// Where the energy of exact regions comes from and goes.

#include <algorithm>

#include "engine/bake/walk/exact_driver.h"

namespace hazumi {

void ExactDriver::Account(double t, bool is_cut) {
  if (accounted_coupling_ && *accounted_coupling_ != hold_.coupling) has_energy_ = false;
  accounted_coupling_ = hold_.coupling;
  for (Group& group : groups_) {
    // A group takes its next step only once all have reached the end of the present one.
    if (is_cut || group.solution.time() <= t) AddWork(&group, t);
  }
}

// Powers over the step so far by Gauss's formula of order 8. What the energy jumped by since the
// step before went into stops.
void ExactDriver::AddWork(Group* group, double t) {
  constexpr double kNode[2] = {0.3399810435848563, 0.8611363115940526};
  constexpr double kWeight[2] = {0.6521451548625461, 0.3478548451374538};
  GroupSolution& solution = group->solution;
  const double start = std::max(group->accounted, solution.step_start());
  const double middle = 0.5 * (start + t), half = 0.5 * (t - start);
  if (half <= 0.0) return;
  const EnergyFlow first = solution.Energy(start), last = solution.Energy(t);
  if (group->is_accounted) {
    energy_.stops += first.kinetic + first.potential - group->stored;
  } else {
    energy_.kinetic_start += first.kinetic;
    energy_.potential_start += first.potential;
  }
  for (const double side : {-1.0, 1.0}) {
    for (int i = 0; i < 2; ++i) {
      const EnergyFlow flow = solution.Energy(middle + side * kNode[i] * half);
      for (const auto& [law, power] : flow.laws) energy_.AddWork(law, half * kWeight[i] * power);
      energy_.keyed += half * kWeight[i] * flow.keyed;
    }
  }
  energy_.kinetic_end += last.kinetic - (group->is_accounted ? group->kinetic : 0.0);
  energy_.potential_end +=
      last.potential - (group->is_accounted ? group->stored - group->kinetic : 0.0);
  group->accounted = t;
  group->stored = last.kinetic + last.potential;
  group->kinetic = last.kinetic;
  group->is_accounted = true;
}

std::optional<EnergyBalance> ExactDriver::energy() const {
  if (!accounted_coupling_ || !has_energy_) return std::nullopt;
  return energy_;
}

}  // namespace hazumi
