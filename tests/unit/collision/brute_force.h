#pragma once

// Slow answers that share no formula with engine/collision: golden-section searches on the convex
// distance, and a convex hull from all triples of corners for the depth.

#include <optional>

#include "engine/collision/shapes.h"

namespace hazumi::test {

// As SignedDistance().value.
double SearchSignedDistance(const Capsule& capsule, const Obstacle& obstacle);

// The gap, as SignedDistance().value where the capsule's axis is outside the obstacle; inside, only
// its sign is right (minus the radius, or less). Faster than the above.
double SearchGap(const Capsule& capsule, const Obstacle& obstacle);

struct SearchedTouch {
  double least_gap = 0.0;   // of SearchGap over the whole path [m]
  std::optional<double> s;  // first touch, if least_gap is 0 or less
};
SearchedTouch SearchFirstTouch(const Capsule& capsule, const Vec3& translation,
                               const Obstacle& obstacle);

Capsule Moved(const Capsule& capsule, const Vec3& by);

}  // namespace hazumi::test
