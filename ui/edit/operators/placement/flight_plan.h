#pragma once

// A flight that keys have, given to gravity: where it takes off, where it lands, and what is in the
// way.

#include <optional>
#include <string>

#include "engine/bake/motion.h"
#include "engine/project/project.h"
#include "engine/timeline/animation.h"
#include "ui/edit/operator.h"

namespace hazumi::edit {

// Frames first..last as they were asked for: the figure leaves the ground on the first, or is in
// the air on it already, and lands on the last, or is in the air on it still.
struct FlightSpan {
  int first = 0, last = 0;
};

// Gives the flight to gravity: it takes off so fast that it lands where the keys have it. Errors
// say what is in the way.
Result<Done> FlyByGravity(const FlightSpan& span, Project* project);

// The CoM's parabola from where the keys have it on the first frame to where they have it on the
// last one.
class FlightArc {
 public:
  FlightArc(const Animation& animation, const Motion& keyed, const FlightSpan& span);

  // Has the arc end elsewhere.
  void EndAt(const Vec3& com);

  Vec3 ComAt(int frame) const;       // [m]
  Vec3 VelocityAt(int frame) const;  // [m/s]
  // The root's origin where the figure, in its keyed pose, has its CoM on the arc.
  Vec3 RootAt(int frame) const;
  // How fast the root goes there, if the limbs move as the keys have them.
  Vec3 RootVelocityAt(int frame) const;
  // Signed distance of that figure to what is nearest to it in the scene, what of the figure and of
  // the scene; nothing without a scene.
  struct Nearness {
    double clearance = 0.0;  // [m]
    std::string link, object;
  };
  std::optional<Nearness> NearnessAt(int frame) const;
  // The same where a motion has the figure.
  std::optional<Nearness> NearnessIn(const MotionFrame& frame) const;

 private:
  const MotionFrame& KeyedAt(int frame) const;
  double SecondsTo(int frame) const;

  const Animation& animation_;
  const Motion& keyed_;
  FlightSpan span_;
  Vec3 start_, velocity_, gravity_;
};

// The frame of a motion, or the nearest that there is.
const MotionFrame& FrameOf(const Motion& motion, int frame);

}  // namespace hazumi::edit
