#pragma once

#include <tuple>
#include <variant>
#include <vector>

#include "engine/passive/forces/attraction.h"
#include "engine/passive/forces/force_law.h"
#include "engine/passive/forces/retention.h"
#include "engine/passive/forces/spring_drive.h"
#include "engine/passive/forces/torque_drive.h"
#include "engine/passive/forces/wind.h"

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
