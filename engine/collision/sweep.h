#pragma once

#include <optional>

#include "engine/collision/shapes.h"

namespace hazumi {

// When does `capsule`, moved by s * translation (W, metres) with s growing from 0 to 1, first touch
// the obstacle? The least s at which SignedDistance is 0 (to 1e-11 m, on the free side); 0 if it
// touches or overlaps to begin with, even if it is about to leave; nothing if it never touches. The
// path is continuous: nothing is too thin or too fast to be hit.
std::optional<double> FirstTouch(const Capsule& capsule, const Vec3& translation,
                                 const Obstacle& obstacle);

}  // namespace hazumi
