#pragma once

#include <vector>

#include "render/scene/scene.h"

namespace hazumi::render {

struct BoundingSphere {
  Vec3 center = Vec3::Zero();
  double radius = 0.0;
};

// Spheres whose convex hull holds every opaque solid of the scene (ghosts throw no shadow).
std::vector<BoundingSphere> CasterSpheres(const Scene& scene);

// An axis-aligned rectangle on the ground [m, world]. Empty when max < min.
struct GroundRect {
  Eigen::Vector2d min{1e30, 1e30};
  Eigen::Vector2d max{-1e30, -1e30};

  bool is_empty() const { return max.x() < min.x(); }
  void Include(const Eigen::Vector2d& center, double radius);
};

// Where the ground may be darkened: under the casters and in their shadows, no farther than 20 m
// from the casters for a low light.
GroundRect ShadedGround(const std::vector<BoundingSphere>& casters, const Vec3& to_light,
                        double ground_height);

}  // namespace hazumi::render
