// The account of an island [METHOD 8.5]: over each of its steps the powers P of laws and of keyed
// joints are integrated by Gauss's formula of order 8,
//   W = h sum_i w_i P(m + h x_i),   h half of the step, m its middle, x_i and w_i below.
// Where that leaves something of the step unexplained its halves are tried, and theirs, as long as
// this changes the sum: powers have kinks where springs give all they can, inside of pulls, at
// breezes. What its energy jumped by since the step before went into limits.

#include "engine/bake/walk/energy_account.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/spatial/checks.h"

namespace hazumi {

namespace {

// Of the laws, in their order, and of keyed joints [J].
using Works = std::vector<double>;

Works GaussWorks(double start, double end, IslandSolution* solution) {
  constexpr double kNode[2] = {0.3399810435848563, 0.8611363115940526};
  constexpr double kWeight[2] = {0.6521451548625461, 0.3478548451374538};
  const double middle = 0.5 * (start + end), half = 0.5 * (end - start);
  Works works;
  for (const double side : {-1.0, 1.0}) {
    for (int i = 0; i < 2; ++i) {
      const EnergyFlow flow = solution->Energy(middle + side * kNode[i] * half);
      works.resize(flow.laws.size() + 1, 0.0);
      for (size_t k = 0; k < flow.laws.size(); ++k) {
        works[k] += half * kWeight[i] * flow.laws[k].power;
      }
      works.back() += half * kWeight[i] * flow.keyed;
    }
  }
  return works;
}

double SumOf(const Works& works) { return std::accumulate(works.begin(), works.end(), 0.0); }

// The works of both halves, or of theirs, until that changes the sum by next to nothing.
Works HalvedWorks(double start, double end, const Works& whole, double least, int halvings,
                  IslandSolution* solution) {
  const double middle = 0.5 * (start + end);
  Works first = GaussWorks(start, middle, solution), second = GaussWorks(middle, end, solution);
  const double change = std::abs(SumOf(first) + SumOf(second) - SumOf(whole));
  if (halvings > 0 && change > least) {
    first = HalvedWorks(start, middle, first, 0.5 * least, halvings - 1, solution);
    second = HalvedWorks(middle, end, second, 0.5 * least, halvings - 1, solution);
  }
  for (size_t k = 0; k < first.size(); ++k) first[k] += second[k];
  return first;
}

}  // namespace

void EnergyAccount::Restart(size_t num_islands) {
  if (islands_.size() != num_islands) islands_.assign(num_islands, Island());
  for (Island& island : islands_) island.until = 0.0;
}

void EnergyAccount::SetCoupling(RootCoupling coupling) {
  if (coupling_ && *coupling_ != coupling) is_whole_ = false;
  coupling_ = coupling;
}

void EnergyAccount::JumpBy(const char* cause) {
  for (Island& island : islands_) island.jumps_by = cause;
}

// What left stays in what there is at the end, what joined was there at the start. Only sums over
// all islands are told: any of them may have it.
void EnergyAccount::Exchange(const Stored& left, const Stored& joined) {
  if (islands_.empty() || !islands_[0].is_accounted) return;
  islands_[0].kinetic += joined.kinetic - left.kinetic;
  islands_[0].stored += joined.sum() - left.sum();
  for (double* kinetic : {&balance_.kinetic_start, &balance_.kinetic_end}) {
    *kinetic += joined.kinetic;
  }
  for (double* potential : {&balance_.potential_start, &balance_.potential_end}) {
    *potential += joined.potential;
  }
}

void EnergyAccount::AddStep(size_t index, double t, IslandSolution* solution) {
  HAZUMI_ASSERT(index < islands_.size());
  HAZUMI_ASSERT(std::isfinite(t));
  Island& island = islands_[index];
  const double start = std::max(island.until, solution->step_start());
  if (0.5 * (t - start) <= 0.0) return;
  const EnergyFlow first = solution->Energy(start), last = solution->Energy(t);
  AddStart(first, island, solution->TakeImpactWork());
  AddWork(start, t, first, last, solution);
  balance_.kinetic_end += last.kinetic - (island.is_accounted ? island.kinetic : 0.0);
  balance_.potential_end +=
      last.potential - (island.is_accounted ? island.stored - island.kinetic : 0.0);
  island = {t, last.kinetic + last.potential, last.kinetic, true, nullptr};
}

// Adds the first step of an island. In an impact with contacts, limits take the work of their own
// impulses, and contacts take the rest. The first impact belongs to contacts that exist where the
// account begins.
void EnergyAccount::AddStart(const EnergyFlow& first, const Island& island,
                             const ImpactWork& impacts) {
  const double jump = first.kinetic + first.potential - island.stored;
  if (island.is_accounted && island.jumps_by) {
    balance_.AddWork(island.jumps_by, jump);
  } else if (island.is_accounted) {
    const double limits = impacts.has_contacts ? impacts.limits : jump;
    balance_.limits += limits;
    balance_.impacts += jump - limits;
  } else {
    balance_.kinetic_start += first.kinetic - impacts.limits - impacts.contacts;
    balance_.limits += impacts.limits;
    balance_.impacts += impacts.contacts;
    balance_.potential_start += first.potential;
  }
}

void EnergyAccount::AddWork(double start, double end, const EnergyFlow& first,
                            const EnergyFlow& last, IslandSolution* solution) {
  HAZUMI_ASSERT(start < end);
  HAZUMI_ASSERT(first.laws.size() == last.laws.size());
  constexpr double kExplained = 1e-9;  // of the energy and of what changes hands
  constexpr int kHalvings = 5;
  Works works = GaussWorks(start, end, solution);
  const double change = last.kinetic + last.potential - first.kinetic - first.potential;
  double turned = std::max(first.kinetic, last.kinetic);
  for (const double work : works) turned += std::abs(work);
  const double least = kExplained * turned;
  if (std::abs(change - SumOf(works)) > least) {
    works = HalvedWorks(start, end, works, least, kHalvings, solution);
  }
  for (size_t k = 0; k < first.laws.size(); ++k) balance_.AddWork(first.laws[k].name, works[k]);
  balance_.keyed += works.back();
}

std::optional<EnergyBalance> EnergyAccount::balance() const {
  if (!coupling_ || !is_whole_) return std::nullopt;
  return balance_;
}

}  // namespace hazumi
