#pragma once

// Internal. The hinges of a joint that is a part of a body: the same for every skeleton.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/figure/body_role.h"
#include "engine/figure/figure_spec.h"
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

// The part that a joint has of the spine, or of the neck and the head, by the places of all joints
// from the root out; of others the whole.
RowPart PartOfRow(const std::vector<BodyPlace>& places, size_t joint);

// Angles that a hinge has in a clip, or at rest [rad].
struct AngleRange {
  double low = 0.0, high = 0.0;
};

// Whether the hinge is fixed: people cannot turn it, and it hardly turns.
bool IsFixed(const BodyHinge& of_body, const AngleRange& range);

// The hinge of a joint: its axis in `frame`, the body axes in the bone's; its limits wider where
// `range` goes farther than people do; its torques times `strength`.
HingeSpec HingeOfBody(const BodyHinge& of_body, const Mat3& frame, const AngleRange& range,
                      double strength);

// Factor of the human's torques for a body of this mass [kg] and height [m].
double StrengthOf(double mass, double height);

// Hinges, limits and strength as the human that comes with Hazumi has them; of a clavicle and of
// fingers, which it has not, see body_hinges.cpp. None if the role has no hinges of its own.
std::optional<BodyHinges> BodyHingesOf(BodyPlace place, const RowPart& part);

}  // namespace hazumi
