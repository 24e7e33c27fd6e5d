#pragma once

#include <vector>

#include "engine/dynamics/workspace.h"
#include "engine/placement/figure_motion.h"
#include "engine/timeline/dynamics_region.h"

namespace hazumi {

// What the springs of a region know of its first frame. One entry for each of its joints; none at
// all if it has no springs.
struct RegionStart {
  std::vector<double> angles;    // [rad]
  std::vector<double> inertias;  // about the hinge, of all that lies beyond it [kg m^2]
  // The same about the joint's origin, of a ball joint; in the ball's frame (BallAxes).
  std::vector<Mat3> of_balls;
};

// Of a figure that is in that motion there.
RegionStart StartOf(const DynamicsRegion& region, const Figure& figure, const FigureMotion& motion,
                    DynamicsWorkspace* ws);

}  // namespace hazumi
