#pragma once

// Internal: the frames of a jump, how the figure stands in each of its phases, and where. The
// equations are in jump_plan.cpp.

#include <array>
#include <functional>
#include <optional>

#include "engine/bake/motion.h"
#include "engine/dynamics/kinematics.h"
#include "engine/project/project.h"
#include "engine/timeline/animation.h"
#include "ui/edit/operator.h"
#include "ui/edit/operators/placement/jump_poses.h"

namespace hazumi::edit {

inline constexpr const char* kToes[] = {"r_toe", "l_toe"};
inline constexpr double kStretchSeconds = 0.07;  // of going on to stretch after take-off

// A pose by hinge and the root's orientation.
struct Stance {
  VecX q;       // [rad]
  Vec3 angles;  // of the root: z, y, x [degrees]
};

// Stances of a figure, put onto the scene. The animation must outlive it.
class Stage {
 public:
  explicit Stage(const Animation& animation);

  // Where the root is if the middle of the toes is above `spot` and the figure, come down from
  // above, touches the scene. Errors: kSchema if there is nothing to stand on.
  Result<Vec3> RootOn(const Stance& stance, const Vec3& spot);
  Vec3 ComOf(const Stance& stance, const Vec3& root);
  Vec3 ToesOf(const Stance& stance, const Vec3& root);

 private:
  void Place(const Stance& stance, const Vec3& root);
  Vec3 Toes() const;

  const Animation& animation_;
  const Figure& figure_;
  DynamicsWorkspace ws_;
};

using JumpFrames = std::array<int, kNumJumpPhases>;

// Which frame each phase is on, and where the root is.
struct JumpPlan {
  int start = 0, end = 0;
  JumpFrames frames{};
  std::array<Stance, kNumJumpPhases> stances;
  std::array<Vec3, kNumJumpPhases> roots;
  Stance before, after;          // how it stands on the first and on the last frame
  Vec3 root_before, root_after;  // and where
  double stretch = 0.0;          // from crouch to take-off [s]
};

// What a jump takes besides its stretch and its flight.
struct JumpLengths {
  int crouch = 0, absorb = 0, rise = 0;  // frames to the crouch, from landing on, until it stands
};

// Of a plan with its stances: the roots, with the toes over `spot` until take-off, then over
// `target`. Errors: kSchema if there is nothing to stand on.
Result<Done> SetRoots(const Vec3& spot, const Vec3& target, Stage* stage, JumpPlan* plan);
// Of a plan with its roots: the frames, for an apex so high above take-off [m]. Errors: kSchema.
Result<Done> SetTimes(const Animation& animation, double height, const JumpLengths& lengths,
                      Stage* stage, JumpPlan* plan);

// The pins on which a jump stands before and after its flight; their frames are the plan's.
struct JumpPins {
  ProjectPlacement before, after;
};
// Keys where the root is (not its angles), and gives the flight to gravity. Nothing else places the
// figure then.
Result<Done> PutJump(const JumpPlan& plan, JumpPins pins, Project* project);

// Jumps so high [m] or, if no height is given, as low as it gets there.
using JumpSoHigh = std::function<Result<Done>(double height, Project* project)>;
Result<Done> JumpAsLow(std::optional<double> height, const JumpSoHigh& jump, Project* project);

}  // namespace hazumi::edit
