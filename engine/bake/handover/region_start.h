#pragma once

#include <vector>

#include "engine/dynamics/workspace.h"
#include "engine/placement/figure_motion.h"
#include "engine/timeline/dynamics_region.h"
#include "engine/timeline/scene_object.h"

namespace hazumi {

// What the springs of a region know of its first frame. One entry for each of its joints; none at
// all if it has no springs.
struct RegionStart {
  std::vector<double> angles;    // [rad]
  std::vector<double> inertias;  // about the hinge, of the bodies that its spring moves [kg m^2]
  // The same about the joint's origin, of a ball joint; in the ball's frame (BallAxes).
  std::vector<Mat3> of_balls;
};

// Returns the start of a region for a figure in this motion [METHOD 2.6]. A spring moves the bodies
// beyond its joint and, if these stand on `scene` (null: no support), the rest of the figure. The
// two are weighted by the share of the weight that is not carried, or carried, beyond the joint.
RegionStart StartOf(const DynamicsRegion& region, const Figure& figure, const FigureMotion& motion,
                    const std::vector<SceneObject>* scene, DynamicsWorkspace* ws);

}  // namespace hazumi
