#pragma once

#include <optional>

#include "engine/collision/shapes.h"

namespace hazumi {

// How far a capsule is from an obstacle, in W. Everything is closed form; for sizes and positions
// up to 100 m, `value` is exact to 1e-12 m or so.
struct Distance {
  // Metres. Positive: the gap. Negative: minus the length of the least translation that separates
  // the two. Zero: they touch.
  double value = 0.0;
  // The capsule's surface point nearest the obstacle; when they overlap, the point that touches
  // last while the capsule leaves along `normal`. Where many points qualify (parallel shapes), one
  // of them.
  Vec3 point_on_capsule = Vec3::Zero();
  // Unit, from the obstacle to the capsule: moving the capsule by -value * normal makes them touch,
  // to rounding. Where nearly parallel shapes leave it open, its direction is good to 1e-5 rad.
  Vec3 normal = Vec3::UnitZ();
};

Distance SignedDistance(const Capsule& capsule, const Plane& plane);
Distance SignedDistance(const Capsule& capsule, const Box& box);
Distance SignedDistance(const Capsule& capsule, const Capsule& obstacle);
Distance SignedDistance(const Capsule& capsule, const Obstacle& obstacle);

// All points within `margin` of a box [m]: what boxes and capsules are.
struct GrownBox {
  Box box;
  double margin = 0.0;
};
GrownBox Grown(const Box& box);
GrownBox Grown(const Capsule& capsule);

// When does `capsule`, moved by s * translation (W, metres) with s growing from 0 to 1, first touch
// the obstacle? The least s at which SignedDistance is 0 (to 1e-11 m, on the free side); 0 if it
// touches or overlaps to begin with, even if it is about to leave; nothing if it never touches. The
// path is continuous: nothing is too thin or too fast to be hit.
std::optional<double> FirstTouch(const Capsule& capsule, const Vec3& translation,
                                 const Obstacle& obstacle);

}  // namespace hazumi
