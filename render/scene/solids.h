#pragma once

#include "engine/spatial/pose.h"
#include "render/scene/color.h"

namespace hazumi::render {

// The solid shapes of a scene, in world coordinates [m]. A colour with alpha < 1 makes the shape a
// ghost: see-through, without a shadow, and never showing its own inner parts.

// Two spheres and the cone tangent to both. If one sphere contains the other, only that one.
// Radii >= 0; a and b may coincide.
struct TaperedCapsule {
  Vec3 a = Vec3::Zero();
  Vec3 b = Vec3::Zero();
  double radius_a = 0.0;
  double radius_b = 0.0;
  SrgbColor color;
};

// `X_WE` places the centre and the axes; `half_axes` are the half lengths along them, > 0.
struct Ellipsoid {
  Pose X_WE;
  Vec3 half_axes = Vec3::Ones();
  SrgbColor color;
};

// `X_WB` places the centre and the axes. Edges are rounded by `bevel` [m], at most the smallest
// half size.
struct BoxShape {
  Pose X_WB;
  Vec3 half_size = Vec3::Ones();
  double bevel = 0.01;
  SrgbColor color;
};

// A sphere is an ellipsoid.
inline Ellipsoid Sphere(const Vec3& center, double radius, const SrgbColor& color) {
  return {{Mat3::Identity(), center}, Vec3::Constant(radius), color};
}

}  // namespace hazumi::render
