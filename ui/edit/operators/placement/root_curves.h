#pragma once

// The root's curves, by RootCurve: where its origin is [m], and the angles of R = Rz Ry Rx
// [degrees].

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/project/project.h"
#include "engine/spatial/pose.h"

namespace hazumi::edit {

inline constexpr const char* kRootCurveNames[kNumRootCurves] = {
    "root.x", "root.y", "root.z", "root.angle_z", "root.angle_y", "root.angle_x"};
std::optional<int> RootCurveNamed(const std::string& name);

// What the curves would have to say for the root to be at `X_WR`. Of the angles that do, those
// nearest to what the keys of `root` say last before the frame, so that no whole turn is keyed.
std::array<double, kNumRootCurves> RootValues(const hazumi::Pose& X_WR, const ProjectRoot& root,
                                              double frame);

// How fast its angles z, y and x change where the root turns with `w` [rad/s], [degrees/s]; none
// near the pose where z and x turn about the same line.
std::optional<std::array<double, 3>> RootAngleRates(
    const std::array<double, kNumRootCurves>& values, const Vec3& w);

}  // namespace hazumi::edit
