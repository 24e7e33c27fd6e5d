#pragma once

#include <optional>
#include <vector>

#include "engine/region/exact/exact_step.h"

namespace hazumi {

// Where in a step the force of a law has a kink. [METHOD 8.1]
class KinkSearch {
 public:
  // Both must outlive it.
  KinkSearch(const RegionDynamics* dynamics, ExactStep* step) : dynamics_(dynamics), step_(step) {}

  // The first time inside a step that has just been taken [s].
  std::optional<double> Find();

 private:
  double KinkAt(int kink, double t);

  const RegionDynamics* dynamics_;
  ExactStep* step_;
  std::vector<double> start_, end_, inside_;
};

}  // namespace hazumi
