#pragma once

#include <optional>
#include <string>

#include "engine/bake/motion.h"
#include "engine/makers/flights/flights.h"
#include "engine/timeline/animation.h"

namespace hazumi::makers {

// Parabola of the CoM from where the keys have it on the first frame of a flight to where they have
// it on the last one. The equations are in flight_arc.cpp. The animation and the keyed motion must
// outlive it.
class FlightArc {
 public:
  FlightArc(const Animation& animation, const Motion& keyed, const FlightSpan& span);

  // Has the arc end elsewhere.
  void EndAt(const Vec3& com);

  Vec3 ComAt(int frame) const;       // [m]
  Vec3 VelocityAt(int frame) const;  // [m/s]
  // Returns the root's origin where the figure, in its keyed pose, has its CoM on the arc [m].
  Vec3 RootAt(int frame) const;
  // Returns the root's velocity there if the limbs move as the keys have them [m/s].
  Vec3 RootVelocityAt(int frame) const;
  // Signed distance of a figure to the nearest object of the scene, and the link and object.
  struct Nearness {
    double clearance = 0.0;  // [m]
    std::string link, object;
  };
  // Returns the nearness of the figure with its CoM on the arc; nothing without a scene.
  std::optional<Nearness> NearnessAt(int frame) const;
  // Returns the nearness of the figure in a frame of a motion.
  std::optional<Nearness> NearnessIn(const MotionFrame& frame) const;

 private:
  const MotionFrame& KeyedAt(int frame) const;
  double SecondsTo(int frame) const;

  const Animation& animation_;
  const Motion& keyed_;
  FlightSpan span_;
  Vec3 start_, velocity_, gravity_;
};

// Returns a frame of a motion, or the nearest that there is.
const MotionFrame& FrameOf(const Motion& motion, int frame);

}  // namespace hazumi::makers
