#pragma once

#include <vector>

#include "engine/dynamics/workspace.h"
#include "engine/figure/figure.h"
#include "engine/spatial/wrench.h"
#include "engine/timeline/scene_object.h"

namespace hazumi {

// One end of a link's capsule that stands on something of the scene.
struct SupportPoint {
  JointIndex joint;             // whose body it is on; invalid: the root's
  Vec3 center = Vec3::Zero();   // of the capsule's end, in that body's frame [m]
  double radius = 0.0;          // [m]
  Vec3 normal = Vec3::UnitZ();  // unit, from the scene to the figure, world
  double weight = 1.0;          // how much of it touches, above 0 and up to 1

  // In the world [m]. Needs ComputePositions.
  Vec3 Place(const DynamicsWorkspace& ws) const {
    const BodyScratch& body = ws.body(joint);
    return body.p + body.R * center - radius * normal;
  }
};

// The ends of all links that are nearer to the scene than 2 cm; their weights fall smoothly to 0
// there. Needs ComputePositions.
std::vector<SupportPoint> FindSupport(const Figure& figure, const std::vector<SceneObject>& scene,
                                      const DynamicsWorkspace& ws);

// The forces [N] at these points that supply a force and its moment about `about` with the least
// sum of force^2 / weight, by those points alone that need not pull. Where they cannot supply all
// of it they come as near as these points can. Needs ComputePositions.
std::vector<Vec3> SupportForces(const std::vector<SupportPoint>& points, const Wrench& needed,
                                const Vec3& about, const DynamicsWorkspace& ws);

// Whether a point moves as hinge i turns.
inline bool IsMovedBy(const Figure& figure, const SupportPoint& point, JointIndex i) {
  return point.joint == i || (point.joint.is_valid() && figure.IsBeyond(point.joint, i));
}

// The share of the figure's weight that points beyond each joint carry while it stands still, from
// 0 to 1. Needs ComputePositions.
std::vector<double> CarriedShares(const Figure& figure, const std::vector<SupportPoint>& points,
                                  const DynamicsWorkspace& ws);

}  // namespace hazumi
