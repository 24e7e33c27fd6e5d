#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "engine/spatial/types.h"

namespace hazumi {

// Axes in the order of the rotation channels, three different ones of 0 x, 1 y, 2 z.
using EulerAxes = std::array<int, 3>;

// "ZYX" and its like. Of fewer letters, such as "Z", the axes not named follow; none if a letter is
// no axis or comes twice.
std::optional<EulerAxes> EulerAxesOf(const std::string& order);

// Rotation by angles[0] about axes[0], then by angles[1] about the turned axes[1], and so on.
Mat3 EulerRotation(const EulerAxes& axes, const Vec3& angles);

// The angles [rad] whose EulerRotation is R; of all these the ones nearest to `previous`. Where the
// first axis and the last fall together, the last angle keeps its previous value.
Vec3 EulerAnglesNear(const Mat3& R, const EulerAxes& axes, const Vec3& previous);

}  // namespace hazumi
