#pragma once

// A way to swing whose steps are equal and chosen from outside.

#include <functional>
#include <string>
#include <vector>

#include "engine/figure/figure.h"
#include "engine/spatial/types.h"

namespace hazumi::bench {

struct StepMethod {
  std::string name;
  int evaluations_per_step;  // of the equations of motion
  // Energy of the figure after a second in so many steps [J], heights from the root; not finite
  // where the program gives up.
  std::function<double(const VecX& q, const VecX& qd, int steps)> energy_after_a_second;
};

// `arm` outlives the methods.
std::vector<StepMethod> PaperStepMethods(const Figure& arm);
std::vector<StepMethod> MujocoStepMethods(const Figure& arm);

}  // namespace hazumi::bench
