#pragma once

// Body axes: how each bone of a skeleton is turned when the body stands upright with its arms
// hanging, whatever its pose at rest.

#include <optional>
#include <vector>

#include "engine/figure/body_role.h"
#include "engine/spatial/pose.h"
#include "engine/spatial/types.h"

namespace hazumi {

// A bone at rest, in a frame with x forward, y left and z up.
struct RestBone {
  BodyPlace place;
  int parent = -1;  // comes before it; -1: none
  Pose X_R;
  std::optional<Vec3> end;  // where the bone ends, if no other bone says so, same frame [m]
};

// The axes by bone: x forward, y left and z up of the standing body, turned along with the bone to
// where it is at rest. The equations are in body_axes.cpp.
std::vector<Mat3> BodyAxesOf(const std::vector<RestBone>& bones);

// Returns the direction in which the body faces at rest, an angle about z from x [rad], told by the
// places of its left and right limbs. None if no limb has two sides.
std::optional<double> FacingOf(const std::vector<RestBone>& bones);

}  // namespace hazumi
