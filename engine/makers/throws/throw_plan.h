#pragma once

// Internal: the frames of a throw that is made, how fast and how steeply its arm swings, and the
// hinges that it moves. The equations are in throw_plan.cpp.

#include <optional>
#include <string>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/body/figure_body.h"
#include "engine/makers/keyed_moves.h"
#include "engine/makers/throws/throw_case.h"
#include "engine/makers/throws/throw_poses.h"
#include "engine/project/edits/holders.h"

namespace hazumi::makers {

// Motion of the shoulder as the region starts.
struct ThrowSwing {
  double speed = 0.0;  // [rad/s]
  double rise = 0.0;   // of the path as it is let go, from the horizontal [rad]
};

// Which frame is what, and from where to where.
struct ThrowPlan {
  HolderSpan holder;
  BodySide side = BodySide::kRight;  // of the hand
  GroupIndex shoulder;               // its joint, which the region moves
  std::string pin;                   // the joint that stands on the ground, on that side
  int start = 0, back = 0, region_first = 0, region_last = 0, end = 0;
  double bearing = 0.0;  // of the spot, to the left of where the figure faces [rad]
  ThrowSwing swing;
  double forward = 0.0;     // from the backswing to the region's start [s]
  bool moves_legs = false;  // nothing else places the figure then
};

using NamedThrowHinge = NamedHinge<ThrowHinge>;

// Every hinge of a figure that a throw by its right or left hand keys.
std::vector<NamedThrowHinge> HingesOfThrow(BodySide side, const Figure& figure);

// Returns the angle to a spot from where the figure faces, counter-clockwise from above [rad].
double BearingOf(const Vec3& spot, const Vec3& from, const Pose& X_WR);
// `shoulder`: the joint of an arm.
Vec3 ShoulderIn(const MotionFrame& frame, GroupIndex shoulder, const Figure& figure);
// Returns the side of the hand that has an object; none if what has it is no part of an arm.
std::optional<BodySide> SideOfHand(const std::string& holder, const Figure& figure);

// Returns the swing of an arm of this length [m].
ThrowSwing SwingFor(const ThrowTarget& target, const Vec3& shoulder, double arm, double gravity);
// Returns how far the arm swings forward until the region starts [rad].
double SwungBy(const ThrowSwing& swing, double forward);
// Returns the frame in which the arm, which began to swing at the angle `back` [rad], throws along
// the direction of the path.
int LikelyRelease(const ThrowSwing& swing, double back, double forward, const ProjectRegion& region,
                  const Animation& animation);

// Plans a throw from how the figure stands. Errors: kSchema, with what to do.
Result<ThrowPlan> PlanThrow(const Animation& animation, const MotionFrame& now,
                            const ThrowTarget& target, const Project& project);

}  // namespace hazumi::makers
