#pragma once

// Makes and aims throws of what a figure holds: ordinary keys, a dynamics region that moves the arm
// from its wind-up on, and a goal: the torques with which the arm lets go of the object so that it
// comes down on a spot.

#include <optional>
#include <string>

#include "engine/bake/motion.h"
#include "engine/base/result.h"
#include "engine/project/project.h"
#include "engine/spatial/degrees.h"
#include "engine/timeline/animation.h"

namespace hazumi::makers {

// Largest angle between the direction in which the figure faces and that of its throw [rad].
inline constexpr double kWidestThrow = 75.0 * kDegree;

struct ThrowTarget {
  int object = 0;                // index of Project::held_objects
  Vec3 spot;                     // where it is to come down, on a surface [m]
  std::optional<double> height;  // rise above the hand [m]; nothing: the throw with the least speed
                                 // that passes what stands in between
  std::optional<ThrowStyle> style = {};  // nothing: as the throw that is there, else as the arm is
                                         // drawn back, else underarm
};

struct ThrowReport {
  std::string region;   // that moves the arm
  int release = 0;      // frame in which the object is let go
  int down = 0;         // first frame in which it lies on the spot
  Vec3 velocity;        // of the object as it is let go, world [m/s]
  double muscle = 0.0;  // largest torque as a share of what the hinge can give
};
struct MadeThrow {
  Project project;
  ThrowReport report;
};

// Makes a throw from how the figure stands in a frame of the motion: the arm is drawn back, throws
// in a region, and comes back. An arm that is drawn back in that frame throws from there. Turns a
// figure that only stands to a target beside or behind it. `animation` and `now`: of the project.
// Errors: kSchema, with what to do instead; kSemantics, with the distance missed.
Result<MadeThrow> MakeThrow(const ThrowTarget& target, const MotionFrame& now,
                            const Animation& animation, const Project& project);

// Aims the next throw from `frame` on, or the last one if there is none. Keys that MakeThrow made
// and nobody changed become those of a throw onto the new spot; a region of the animator throws
// from how it begins. `animation` and `motion`: of the project. Errors: as MakeThrow.
Result<MadeThrow> AimThrow(const ThrowTarget& target, double frame, const Animation& animation,
                           const Motion& motion, const Project& project);

// Whether AimThrow finds a throw of the object. Not while somebody has the object who keeps it.
bool HasThrow(int object, double frame, const Animation& animation, const Project& project);

}  // namespace hazumi::makers
