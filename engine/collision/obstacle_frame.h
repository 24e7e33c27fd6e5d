#pragma once

#include <variant>

#include "engine/collision/shapes.h"

namespace hazumi {

// The frame that what is fixed to an obstacle is told in, in W: a box's own; a plane's has its
// origin on the plane and the world's axes. Capsules are given in W itself.
inline Pose FrameOf(const Plane& plane) { return {Mat3::Identity(), plane.normal * plane.offset}; }
inline Pose FrameOf(const Box& box) { return box.X_WB; }
inline Pose FrameOf(const Capsule&) { return {}; }
inline Pose FrameOf(const Obstacle& obstacle) {
  return std::visit([](const auto& shape) { return FrameOf(shape); }, obstacle);
}

}  // namespace hazumi
