#pragma once

// Internal: the frames of a throw that is made, how large it is, and the angles of its keys.

#include <optional>
#include <string>
#include <vector>

#include "engine/bake/motion.h"
#include "engine/makers/throws/throw_poses.h"
#include "engine/makers/throws/throws.h"
#include "engine/project/edits/holders.h"

namespace hazumi::makers {

// Data that the poses of a throw depend on.
struct ThrowShape {
  BodySide side = BodySide::kRight;  // of the hand
  ThrowStyle style = ThrowStyle::kUnderarm;
  double bearing = 0.0;  // of the spot, to the left of where the figure faces [rad]
  double size = 1.0;     // 1: the poses are whole; less: nearer to that of the release
};

// Returns the shape of a throw from how the figure stands. `spot`: of the object's centre [m].
ThrowShape ShapeOf(BodySide side, ThrowStyle style, const Vec3& spot, const MotionFrame& standing,
                   const Animation& animation);
// Returns where an object's centre is as it lies on a spot of a surface [m].
Vec3 CentreOn(const Vec3& spot, int object, const Animation& animation);

// Returns the angle of a hinge in a phase, within its limits [degrees].
double AngleIn(ThrowPhase phase, const NamedThrowHinge& of, const ThrowShape& shape,
               const Figure& figure);

// Which frame is what.
struct ThrowPlan {
  HolderSpan holder;
  ThrowShape shape;
  GroupIndex shoulder;         // its joint, which the region moves
  std::string pin;             // the joint that stands on the ground, on that side
  bool is_drawn_back = false;  // in the first frame, which is kWindUp then
  int start = 0, wind_up = 0, release = 0, region_last = 0, end = 0;
  bool moves_legs = false;  // nothing else places the figure then
  int swung() const;        // frame in which trunk and legs are in the pose of the release
  int passes() const;       // frame in which the arm is half-way back
};

// Frames from the wind-up to the release, and from the region's end until the arm is back.
int ForwardFrames(ThrowStyle style, const Animation& animation);
int HomeFrames(const Animation& animation);
// The style that an arm is drawn back for; nothing: it hangs, or its hand is in front.
std::optional<ThrowStyle> StyleDrawnBack(BodySide side, const MotionFrame& frame,
                                         const Figure& figure);
// Returns the angle to a spot from where the figure faces, counter-clockwise from above [rad].
double BearingOf(const Vec3& spot, const Vec3& from, const Pose& X_WR);

// Plans a throw from how the figure stands. Errors: kSchema, with what to do.
Result<ThrowPlan> PlanThrow(const Animation& animation, const MotionFrame& now,
                            const ThrowTarget& target, const Project& project);

}  // namespace hazumi::makers
