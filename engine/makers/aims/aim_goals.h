#pragma once

// Internal. Goals of an aim with names resolved, in SI units, and how far a motion misses them.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/makers/throws/throw_path.h"
#include "engine/timeline/animation.h"
#include "engine/timeline/goal_kind.h"

namespace hazumi::makers {

// Height and style that are asked of a throw.
struct ThrowAsked {
  std::optional<double> height;  // rise above where it is let go [m]; nothing: the least speed
  ThrowStyle style = ThrowStyle::kUnderarm;
  double gravity = 0.0;   // [m/s^2]
  double firmness = 1.0;  // how firmly it keeps to the style's pose
};

// State that a motion has to reach in a frame: angles of hinges, the place of a point, or a motion
// of a point with which what is let go there flies to a place.
struct AimGoal {
  std::string name;
  int frame = 0;                                      // of the animation
  std::vector<std::pair<JointIndex, double>> angles;  // of limp hinges [rad]
  JointIndex joint;                                   // valid: the point is on the body beyond it
  Vec3 offset = Vec3::Zero(), place = Vec3::Zero();   // of the point: in its frame, world [m]
  std::optional<ThrowAsked> thrown;                   // the place is where it comes down
  bool rests = false;                                 // the hinges that move it stand still
  double tolerance = 0.0;                             // of each angle [rad], of the place [m]

  bool has_point() const { return joint.is_valid(); }
  bool is_place() const { return has_point() && !thrown; }
};

// Hinges that an aim may give torques: a region's own, without another drive, not frozen by
// friction, with some mass beyond. By JointIndex.
std::vector<char> LimpHinges(const DynamicsRegion& region, const Figure& figure);

// Hinges of a region that have to stand still for a goal: those that it names, or that carry its
// point.
std::vector<JointIndex> RestingHinges(const AimGoal& goal, const DynamicsRegion& region,
                                      const Figure& figure);

// State of the figure as a motion arrives at a frame.
inline const MotionLimit& ArrivalAt(int frame, const Motion& motion) {
  return motion.frames[static_cast<size_t>(frame - motion.frames[0].frame)].before;
}

// Place and velocity of a goal's point in a state of the figure.
ThrowPath PathOf(const AimGoal& goal, const MotionLimit& at, const Figure& figure);
// Distance, as a vector, of a path from the place of a goal with a point; of a throw that of
// MissOfSpot [m].
Vec3 OffPlace(const AimGoal& goal, const ThrowPath& path);

// Distance of a motion from a goal.
struct GoalMiss {
  double angle = 0.0;     // of the hinge that is farthest off [rad] ...
  double distance = 0.0;  // ... or of the point [m]
  double rate = 0.0;      // of the fastest hinge, if it is to rest [rad/s]
  JointIndex joint;       // of `angle`
  bool IsMet(const AimGoal& goal) const;
};
inline constexpr double kRestRate =
    0.14;  // largest rate of a hinge that rests: 8 degrees/s [rad/s]
GoalMiss MissOf(const AimGoal& goal, const DynamicsRegion& region, const Figure& figure,
                const Motion& motion);

}  // namespace hazumi::makers
