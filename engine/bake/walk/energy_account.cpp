// The account of an island [METHOD 8.5]: over each of its steps the powers P of laws and of keyed
// joints are integrated by Gauss's formula of order 8,
//   W = h sum_i w_i P(m + h x_i),   h half of the step, m its middle, x_i and w_i below.
// What its energy jumped by since the step before went into limits.

#include "engine/bake/walk/energy_account.h"

#include <algorithm>

namespace hazumi {

void EnergyAccount::Restart(size_t num_islands) {
  if (islands_.size() != num_islands) islands_.assign(num_islands, Island());
  for (Island& island : islands_) island.until = 0.0;
}

void EnergyAccount::SetCoupling(RootCoupling coupling) {
  if (coupling_ && *coupling_ != coupling) is_whole_ = false;
  coupling_ = coupling;
}

void EnergyAccount::JumpByPush() {
  for (Island& island : islands_) island.is_pushed = true;
}

void EnergyAccount::AddStep(size_t index, double t, IslandSolution* solution) {
  Island& island = islands_[index];
  const double start = std::max(island.until, solution->step_start());
  if (0.5 * (t - start) <= 0.0) return;
  const EnergyFlow first = solution->Energy(start), last = solution->Energy(t);
  AddStart(first, island);
  AddWork(start, t, solution);
  balance_.kinetic_end += last.kinetic - (island.is_accounted ? island.kinetic : 0.0);
  balance_.potential_end +=
      last.potential - (island.is_accounted ? island.stored - island.kinetic : 0.0);
  island = {t, last.kinetic + last.potential, last.kinetic, true, false};
}

void EnergyAccount::AddStart(const EnergyFlow& first, const Island& island) {
  if (island.is_accounted && island.is_pushed) {
    balance_.AddWork("push", first.kinetic + first.potential - island.stored);
  } else if (island.is_accounted) {
    balance_.limits += first.kinetic + first.potential - island.stored;
  } else {
    balance_.kinetic_start += first.kinetic;
    balance_.potential_start += first.potential;
  }
}

void EnergyAccount::AddWork(double start, double end, IslandSolution* solution) {
  constexpr double kNode[2] = {0.3399810435848563, 0.8611363115940526};
  constexpr double kWeight[2] = {0.6521451548625461, 0.3478548451374538};
  const double middle = 0.5 * (start + end), half = 0.5 * (end - start);
  for (const double side : {-1.0, 1.0}) {
    for (int i = 0; i < 2; ++i) {
      const EnergyFlow flow = solution->Energy(middle + side * kNode[i] * half);
      for (const auto& [law, power] : flow.laws) balance_.AddWork(law, half * kWeight[i] * power);
      balance_.keyed += half * kWeight[i] * flow.keyed;
    }
  }
}

std::optional<EnergyBalance> EnergyAccount::balance() const {
  if (!coupling_ || !is_whole_) return std::nullopt;
  return balance_;
}

}  // namespace hazumi
