#pragma once

#include <optional>
#include <vector>

#include "engine/bake/island_solution.h"
#include "engine/bake/motion.h"

namespace hazumi {

// Where the energy of a driver's islands comes from and goes, added up step by step.
class EnergyAccount {
 public:
  // Islands begin anew: if there are as many as before, each goes on with what it had.
  void Restart(size_t num_islands);
  // The root is coupled so in the steps that follow.
  void SetCoupling(RootCoupling coupling);
  // Books any energy jump before the next step as the work of `cause`: "push", or "handover" where
  // held objects change hands and the mass of the islands changes.
  void JumpBy(const char* cause);
  // Of what moves with the islands: so much left, and so much joined them, before the next step.
  struct Stored {
    double kinetic = 0.0, potential = 0.0;  // [J]
    double sum() const { return kinetic + potential; }
  };
  void Exchange(const Stored& left, const Stored& joined);
  // An island's step, up to t [s].
  void AddStep(size_t island, double t, IslandSolution* solution);
  // None if there was no step, or if the root's coupling changed on the way: kinetic energy is not
  // the same thing then.
  std::optional<EnergyBalance> balance() const;

 private:
  struct Island {
    double until = 0.0;                  // accounted up to this time [s]
    double stored = 0.0, kinetic = 0.0;  // energy there [J]
    bool is_accounted = false;
    const char* jumps_by = nullptr;  // cause of a jump since then; null: impacts
  };

  void AddStart(const EnergyFlow& first, const Island& island, const ImpactWork& impacts);
  // From energies `first` at its start to `last` at its end.
  void AddWork(double start, double end, const EnergyFlow& first, const EnergyFlow& last,
               IslandSolution* solution);

  std::vector<Island> islands_;
  EnergyBalance balance_;
  std::optional<RootCoupling> coupling_;
  bool is_whole_ = true;
};

}  // namespace hazumi
