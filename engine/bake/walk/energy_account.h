#pragma once

#include <optional>
#include <vector>

#include "engine/bake/group_solution.h"
#include "engine/bake/motion.h"

namespace hazumi {

// Where the energy of a driver's groups comes from and goes, added up step by step.
class EnergyAccount {
 public:
  // Groups begin anew: if there are as many as before, each goes on with what it had.
  void Restart(size_t num_groups);
  // The root is coupled so in the steps that follow.
  void SetCoupling(RootCoupling coupling);
  // A group's step, up to t [s].
  void AddStep(size_t group, double t, GroupSolution* solution);
  // None if there was no step, or if the root's coupling changed on the way: kinetic energy is not
  // the same thing then.
  std::optional<EnergyBalance> balance() const;

 private:
  struct Group {
    double until = 0.0;                  // accounted up to this time [s]
    double stored = 0.0, kinetic = 0.0;  // energy there [J]
    bool is_accounted = false;
  };

  void AddStart(const EnergyFlow& first, const Group& group);
  void AddWork(double start, double end, GroupSolution* solution);

  std::vector<Group> groups_;
  EnergyBalance balance_;
  std::optional<RootCoupling> coupling_;
  bool is_whole_ = true;
};

}  // namespace hazumi
