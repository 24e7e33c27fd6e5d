#pragma once

#include <vector>

#include "engine/dynamics/workspace.h"
#include "engine/figure/figure.h"
#include "engine/spatial/wrench.h"
#include "engine/timeline/scene_object.h"

namespace hazumi {

// End of a link's capsule that stands on an object of the scene.
struct SupportPoint {
  JointIndex joint;             // joint of the body; invalid: the root's body
  Vec3 center = Vec3::Zero();   // center of the capsule's end in the frame of that body [m]
  double radius = 0.0;          // [m]
  Vec3 normal = Vec3::UnitZ();  // unit, from the scene to the figure, world
  double weight = 1.0;          // contact weight, above 0 and up to 1

  // Position in the world [m]. Needs ComputePositions.
  Vec3 Place(const DynamicsWorkspace& ws) const {
    const BodyScratch& body = ws.body(joint);
    return body.p + body.R * center - radius * normal;
  }
};

// Ends of all links within 2 cm of the scene. Their weights fall smoothly to 0 at that distance.
// Needs ComputePositions.
std::vector<SupportPoint> FindSupport(const Figure& figure, const std::vector<SceneObject>& scene,
                                      const DynamicsWorkspace& ws);

// Forces [N] at these points that supply a force and its moment about `about` with the least sum of
// force^2 / weight. Points whose force would pull are excluded. Forces that cannot supply all of it
// minimize the residual. Needs ComputePositions.
std::vector<Vec3> SupportForces(const std::vector<SupportPoint>& points, const Wrench& needed,
                                const Vec3& about, const DynamicsWorkspace& ws);

// Returns whether a point moves with hinge i.
inline bool IsMovedBy(const Figure& figure, const SupportPoint& point, JointIndex i) {
  return figure.IsBeyond(point.joint, i);  // never where the root's own body touches
}

// Shares of the figure's weight that the points beyond each joint carry at rest, from 0 to 1. Needs
// ComputePositions.
std::vector<double> CarriedShares(const Figure& figure, const std::vector<SupportPoint>& points,
                                  const DynamicsWorkspace& ws);

}  // namespace hazumi
