#pragma once

#include <limits>
#include <optional>

#include "engine/region/contact/contact_spec.h"
#include "engine/spatial/small.h"

namespace hazumi {

// A capsule in the world, and how it moves.
struct MovingCapsule {
  small::V3 a, b;  // ends of its axis [m]
  small::V3 v, w;  // of a [m/s]; of its body [rad/s]
  double radius = 0.0;
};

// Where one feature of a capsule is nearest to one of an obstacle, or of another capsule: a point
// on the capsule, which glides over both as they move.
struct TouchPoint {
  double gap = 0.0;        // [m], negative inside
  small::V3 p, n;          // in the world; n unit, from the other to the capsule
  small::V3 v;             // of the capsule's material there, against the other's [m/s]
  small::V3 p_dot, n_dot;  // [m/s, 1/s]
  // By how much v changes as the point glides over both, beside accelerations of what is fixed to
  // them [m/s^2].
  small::V3 glides;
  // How far the point is from where the pair is the nearest one [m]; negative where it is.
  double beyond = -std::numeric_limits<double>::infinity();
};

// The pairs of features that can touch: both ends of the axis with an obstacle as a whole, what
// lies between them with a box's 12 edges and 8 corners.
inline constexpr int kPlanePairs = 2, kBoxPairs = 2 + 12 + 8;
inline int NumPairs(const ContactObstacle& obstacle) {
  return obstacle.is_box ? kBoxPairs : kPlanePairs;
}

// None where the pair is not the nearest one around. `is_touching`: it is in contact, and is
// followed a little beyond where it is the nearest.
std::optional<TouchPoint> TouchPointOf(int pair, const MovingCapsule& capsule,
                                       const ContactObstacle& obstacle, bool is_touching);

// No feature is nearer to the obstacle than this [m].
double LeastGap(const MovingCapsule& capsule, const ContactObstacle& obstacle);

// The same of two capsules: both ends of the first axis with the other as a whole, both ends of
// that with what lies between the first ones, and what lies between both.
inline constexpr int kCapsulePairs = 5;
std::optional<TouchPoint> TouchPointOf(int pair, const MovingCapsule& capsule,
                                       const MovingCapsule& other, bool is_touching);
double LeastGap(const MovingCapsule& capsule, const MovingCapsule& other);

}  // namespace hazumi
