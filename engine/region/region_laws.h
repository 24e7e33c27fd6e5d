#pragma once

#include <vector>

#include "engine/region/forces/force_law.h"

namespace hazumi {

class FreeBodies;
struct StepForces;

// Placed nodes on which all forces act: the second stage, returned by RegionLaws::Load. The
// equations of motion are assembled from it.
class LoadedState {
 public:
  const RegionState& state() const { return state_; }
  NodeKinematics* nodes() const { return nodes_; }

 private:
  friend class RegionLaws;
  LoadedState(const RegionState& state, NodeKinematics* nodes) : state_(state), nodes_(nodes) {}

  RegionState state_;
  NodeKinematics* nodes_;
};

// The force laws of an island, and which kinds of laws there are.
class RegionLaws {
 public:
  explicit RegionLaws(ForceLaws laws);

  const ForceLaws& all() const { return laws_; }
  bool any_forces() const { return any_forces_; }
  bool any_rules() const { return any_rules_; }
  bool any_outer() const { return any_outer_; }
  bool any_springs() const { return any_springs_; }
  // Returns whether any force has a kink. Springs whose moments are constant have none.
  bool any_kinks(bool with_springs = true) const {
    return with_springs ? any_kinks_ : any_other_kinks_;
  }
  // Fastest rate at which a law changes a motion [1/s].
  double FastestRate() const;

  // Adds the forces of time stepping and of all laws to nodes that are placed at `state`.
  LoadedState Load(const RegionState& state, const StepForces& constant, const FreeBodies& bodies,
                   NodeKinematics* nodes) const;
  // Adds the forces of one law, or the constant moments that replace it.
  static void AddForces(const ForceLaw& law, const RegionState& state, const StepForces& constant,
                        NodeKinematics* nodes);

  // Kinks of all laws, as ForceLaw has them.
  void FindKinks(const RegionState& state, bool with_springs, std::vector<double>* kinks) const;
  std::vector<JointSpring> Springs(const RegionState& state) const;
  // Limits the moment of springs on a node to what they can give, world axes [N m].
  Vec3 LimitSprings(const RegionState& state, int node, Vec3 moment) const;
  // Drives that give all they can.
  std::vector<SpentDrive> Spent(const RegionState& state) const;

 private:
  ForceLaws laws_;
  bool any_forces_ = false, any_rules_ = false, any_outer_ = false, any_springs_ = false;
  bool any_kinks_ = false, any_other_kinks_ = false;
};

}  // namespace hazumi
