#pragma once

#include <variant>

#include "engine/spatial/pose.h"
#include "engine/spatial/types.h"

namespace hazumi {

// The points within `radius` of the segment from a to b; a == b is a sphere. Metres, the frame of
// the obstacles it is compared with (W in this folder). radius >= 0.
struct Capsule {
  Vec3 a = Vec3::Zero(), b = Vec3::Zero();
  double radius = 0.0;
  bool operator==(const Capsule&) const = default;
};

// The solid half-space {x : normal . x <= offset}, in W. `normal` is a unit vector and points out
// of the solid; offset in metres.
struct Plane {
  Vec3 normal = Vec3::UnitZ();
  double offset = 0.0;
  bool operator==(const Plane&) const = default;
};

// A solid box centred on B's origin with edges along B's axes. half_size >= 0, in metres; a zero
// makes it a plate, a rod or a point.
struct Box {
  Pose X_WB;
  Vec3 half_size = Vec3::Zero();
  bool operator==(const Box&) const = default;
};

using Obstacle = std::variant<Plane, Box, Capsule>;

// The frame that what is fixed to an obstacle is told in, in W: a box's own; a plane's has its
// origin on the plane and the world's axes. Capsules are given in W itself.
inline Pose FrameOf(const Plane& plane) { return {Mat3::Identity(), plane.normal * plane.offset}; }
inline Pose FrameOf(const Box& box) { return box.X_WB; }
inline Pose FrameOf(const Capsule&) { return {}; }
inline Pose FrameOf(const Obstacle& obstacle) {
  return std::visit([](const auto& shape) { return FrameOf(shape); }, obstacle);
}

}  // namespace hazumi
