#pragma once

#include <tuple>
#include <variant>
#include <vector>

#include "engine/region/forces/attraction.h"
#include "engine/region/forces/force_law.h"
#include "engine/region/forces/retention.h"
#include "engine/region/forces/spring_drive.h"
#include "engine/region/forces/torque_drive.h"
#include "engine/region/forces/wind.h"

namespace hazumi {

// What acts on an island of joints, as plain values that can be compared: one struct for each law.
using ForceSpec = std::variant<RetentionSpec, TorqueSpec, SpringSpec, WindSpec, AttractionSpec>;

// Whether any of them does (ForceLaw::is_outer).
bool ActsFromOutside(const std::vector<ForceSpec>& specs);
// The laws themselves, in the same order.
ForceLaws MakeLaws(const std::vector<ForceSpec>& specs);
// Friction alone, with rates as RetentionSpec has them; no law if they are 0.
ForceLaws FrictionAlone(VecX rates);

}  // namespace hazumi
