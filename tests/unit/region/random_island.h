#pragma once

#include <cstdint>
#include <memory>

#include "engine/region/region_dynamics.h"
#include "tests/support/random.h"

namespace hazumi::test {

// One island of free joints of a random tree at t = 0, some of whose other joints are driven.
// Pinned by any joint. In flight its root turns freely, is driven or constant.
struct RandomIsland {
  // Null where nothing is free.
  static std::unique_ptr<RandomIsland> Of(uint64_t seed, RootCoupling coupling);

  static constexpr double kGravity = 9.81;

  Random random;
  DrivenMotion driven;
  RegionModel model;
  VecX q, qd;  // free hinges [rad, rad/s]
};

// Its nodes, moved as a layout says, with their forces and inertias.
NodeKinematics MovedBy(const RandomIsland& island, const RegionLayout& layout);

// M and b in the coordinates of all free hinges, by the dense equations.
IslandEquations Assembled(const RandomIsland& island);

}  // namespace hazumi::test
