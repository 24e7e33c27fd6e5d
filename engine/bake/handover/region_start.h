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
  std::vector<double> inertias;  // about the hinge, of what its spring moves [kg m^2]
  // The same about the joint's origin, of a ball joint; in the ball's frame (BallAxes).
  std::vector<Mat3> of_balls;
};

// Of a figure that is in that motion there. A spring moves what lies beyond its joint or, where
// that stands on `scene` (null: nothing is stood on), the rest of the figure, each by the share of
// the weight that is not, or is, carried there. [METHOD 2.6]
RegionStart StartOf(const DynamicsRegion& region, const Figure& figure, const FigureMotion& motion,
                    const std::vector<SceneObject>* scene, DynamicsWorkspace* ws);

}  // namespace hazumi
