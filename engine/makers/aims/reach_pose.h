#pragma once

// Internal. A pose that brings a point of a limb to a place, within the limits of its hinges.

#include <functional>
#include <vector>

#include "engine/spatial/pose.h"
#include "engine/spatial/types.h"

namespace hazumi::makers {

// Hinges in a row, each in the frame of the one before.
struct ReachHinge {
  Pose X_PJ;                        // its frame at angle 0
  Vec3 axis;                        // in its own frame
  double lower = 0.0, upper = 0.0;  // [rad]
  double wanted = 0.0;              // the pose is to be near this angle ...
  double other = 0.0;               // ... and may be looked for from here as well [rad]
};

struct Reach {
  VecX angles;            // [rad]
  double distance = 0.0;  // that is left from the point to the place [m]
};

// `offset`: of the point, in the frame of the last hinge [m]. Of poses that reach the place the one
// nearest to the angles wanted, as shares of ranges; else the one that comes nearest to the place.
// `depth`: how deep angles bring the limb into what it stays out of [m]; of poses that reach the
// place those that are not deep go first.
Reach ReachFor(const Pose& carrier, const std::vector<ReachHinge>& hinges, const Vec3& offset,
               const Vec3& place, const std::function<double(const VecX&)>& depth = {});

}  // namespace hazumi::makers
