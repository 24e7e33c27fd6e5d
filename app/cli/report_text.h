#pragma once

// What reports say in words.

#include <string>
#include <vector>

#include "engine/bake/motion.h"

namespace hazumi {

// "paper at 0.01 s", "exact to 0.01 deg".
std::string FinenessText(Method method, double step, double tolerance);

// "14 of 37 joints", "14 of 37 joints, 2 groups of 7, 6 bodies" where a model was made.
std::string ModelText(const RegionReport& report, bool with_root);

// "kinetic 1.2 to 3.4 J, potential ..., friction -0.2 J, ...".
std::string EnergyText(const EnergyBalance& energy);

// What was modelled, what it took, and where the energy went if that is known.
std::vector<std::string> LinesOf(const RegionReport& report, bool with_root);

}  // namespace hazumi
