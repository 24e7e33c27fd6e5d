#pragma once

// Where a figure touches the scene in the course of a motion.

#include <vector>

#include "engine/analysis/contact_forces.h"
#include "engine/analysis/placed_frames.h"
#include "engine/bake/motion.h"
#include "engine/collision/distance.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// When a point counts as touching. touching.cpp says how its weight fades.
struct TouchLimits {
  double clearance = 0.01;  // [m], at most
  // The ground of a capture is not quite where the scene has it: clearances count from the lowest
  // within 0.3 s, if that is at most so far from the scene [m].
  double drift = 0.0;
  double fastest = 1e300;    // [m/s]
  double fade_frames = 3.0;  // of the animation, about a touch-down or a lift-off
};

// Both ends of each link (of soles: heel, ball, toes) against the ground and everything else in the
// scene: how much of each touches in each frame of a motion.
class Touching {
 public:
  // Of a motion of so many frames. `limits`: of all points. The animation must outlive it.
  Touching(const Animation& animation, size_t num_frames, const TouchLimits& limits);

  // Frame by frame, in order.
  void Add(const PlacedFrame& placed);
  // After all frames, `frame_time` [s] apart: weights.
  void Finish(double frame_time);
  // Adds those that touch in a frame. A link's end touches with two points,
  // a radius to either side of its axis.
  void PointsAt(size_t frame, const PlacedFrame& placed, std::vector<ContactPoint>* points) const;

 private:
  struct End {
    int link;
    bool is_b;  // of the capsule; else a
  };
  Capsule BallOf(const End& end, const PlacedFrame& placed) const;
  // Of everything in the scene.
  Distance NearestTo(const Capsule& ball) const;
  void FindLevels(double frame_time);
  void Fade(size_t end, double frame_time);

  const Animation& animation_;
  TouchLimits limits_;
  std::vector<End> ends_;
  size_t num_frames_ = 0;
  std::vector<float> clearance_;  // by frame and end [m]
  std::vector<Vec3> centre_;      // by frame and end [m]; kept if speeds count
  std::vector<double> level_;     // by frame: of the ground, over the scene's [m]
  std::vector<float> weight_;     // by frame and end
};

}  // namespace hazumi
