#pragma once

// Internal. The hinges of a joint that is a part of a body: the same for every skeleton.

#include <array>
#include <optional>
#include <string>

#include "engine/figure/body_role.h"
#include "engine/figure/strength.h"
#include "engine/spatial/types.h"

namespace hazumi {

struct BodyHinge {
  std::string name;
  int axis = 1;       // of the body axes: 0 x, 1 y, 2 z
  double sign = 1.0;  // the hinge is along the axis, or against it
  // Whether people can turn it. Else it is there only for clips that turn it.
  bool is_usual = true;
  double lower = 0.0, upper = 0.0;  // [rad]; of a usual one
  std::optional<JointStrength> strength;
};
using BodyHinges = std::array<BodyHinge, 3>;  // from the parent out

// Part of a row of joints that does together what the human's joints do, such as a spine.
struct RowPart {
  double begin = 0.0, end = 1.0;
};

// Hinges, limits and strength as the human that comes with Hazumi has them; of a clavicle and of
// fingers, which it has not, see body_hinges.cpp. None if the role has no hinges of its own.
std::optional<BodyHinges> BodyHingesOf(BodyPlace place, const RowPart& part);

}  // namespace hazumi
