#pragma once

// Edits of where the figure stands: spans of placement, values of the root's curves.

#include <array>
#include <optional>
#include <vector>

#include "engine/base/result.h"
#include "engine/project/project.h"
#include "engine/spatial/pose.h"

namespace hazumi {

// Inserts a span of placement; earlier spans lose its frames. If not `is_said`, nothing is
// inserted: the root's keys place the figure there. Errors: kSchema if the span has no frames.
Result<Done> PutPlacement(ProjectPlacement span, bool is_said,
                          std::vector<ProjectPlacement>* spans);

// Returns the values of the root's curves, by RootCurve, that place the root at `X_WR` [m, deg]. Of
// the angles that do, they are the nearest to those of the last key before the frame, so that no
// whole turn is keyed.
std::array<double, kNumRootCurves> RootValues(const Pose& X_WR, const ProjectRoot& root,
                                              double frame);

// Returns the rates of the root's angles z, y and x [deg/s] as it turns with the angular velocity
// `w` (world) [rad/s]; nothing near the pose where z and x turn about the same line.
std::optional<std::array<double, 3>> RootAngleRates(
    const std::array<double, kNumRootCurves>& values, const Vec3& w);

}  // namespace hazumi
