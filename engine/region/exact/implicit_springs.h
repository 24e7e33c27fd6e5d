#pragma once

#include <vector>

#include "engine/region/contact/step_forces.h"
#include "engine/region/region_laws.h"

namespace hazumi {

// Springs in joints that are implicit in a time step. [METHOD 12.4]
class ImplicitSprings {
 public:
  // Lists the springs that the laws have in a state. Replaces those of the step before.
  void List(const RegionLaws& laws, const RegionState& state) { springs_ = laws.Springs(state); }
  // Adds the springs to M and b of the free hinges, for a step of h seconds from the state.
  void AddTo(double h, const RegionState& state, MatX* M, VecX* b) const;
  // Adds the moments at the end of the step to `constant`, within the limits of the laws. `change`:
  // of the rates of the free hinges in the step.
  void Keep(double h, const VecX& change, const RegionLaws& laws, const RegionState& state,
            StepForces* constant) const;

 private:
  std::vector<JointSpring> springs_;
};

}  // namespace hazumi
