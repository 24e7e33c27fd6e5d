#pragma once

// Where a figure touches the scene in the course of a motion.

#include <vector>

#include "engine/analysis/contact_forces.h"
#include "engine/analysis/placed_frames.h"
#include "engine/bake/motion.h"
#include "engine/collision/shapes.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// As the kernels read it.
TouchedShape PrepareShape(const Obstacle& shape);

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
  Touching(const Animation& animation, size_t num_frames, const TouchLimits& limits,
           const EffortKernels& kernels = BestEffortKernels());

  // Of the next four frames, in order; behind the last frame anything.
  void AddFour(const double* placed);
  // After all frames, `frame_time` [s] apart: weights.
  void Finish(double frame_time);
  // Adds those that touch in a frame. A link's end touches with two points,
  // a radius to either side of its axis.
  void PointsAt(size_t frame, const PlacedFrame& placed, std::vector<ContactPoint>* points) const;

 private:
  struct End {
    JointIndex joint;
    Vec3 axis;  // of the link, in the frame of its joint, unit; of a ball zero
  };
  void AddEnd(const Link& link, const Vec3& centre);
  // Four numbers of a frame apart from each other: TouchField.
  Vec3 FieldAt(size_t frame, size_t end, int field) const;
  void FindLevels(double frame_time);
  void Fade(size_t end, double frame_time);

  const Animation& animation_;
  TouchLimits limits_;
  EffortKernels kernels_;
  std::vector<End> ends_;
  std::vector<TouchingBall> balls_;  // by end
  std::vector<TouchedShape> shapes_;
  size_t num_frames_, num_fours_, num_added_ = 0;
  LaneArray touches_;          // by four frames, end, TouchField and frame
  LaneArray clearance_;        // by end and frame, up to a whole four [m]
  std::vector<double> level_;  // by frame: of the ground, over the scene's [m]
  std::vector<float> weight_;  // by end and frame
};

}  // namespace hazumi
