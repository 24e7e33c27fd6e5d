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

// Limits within which a point counts as touching. touching.cpp describes the fading of its weight.
struct TouchLimits {
  double clearance = 0.01;  // largest clearance [m]
  // The ground of a capture is not quite where the scene has it: clearances count from the lowest
  // within 0.3 s, if that is at most so far from the scene [m].
  double drift = 0.0;
  double fastest = 1e300;    // [m/s]
  double fade_frames = 3.0;  // frames of the animation, after touch-down and before lift-off
};

// Rises smoothly from 0 at u = 0 to 1 at u = 1, and stays 0 before and 1 after.
double FadeIn(double u);

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

  // Ball at one end of a link.
  struct End {
    JointIndex joint;
    Vec3 axis;    // unit axis of the link in the joint's frame; zero for a ball
    Vec3 centre;  // in the joint's frame [m]
    double radius = 0.0;
    int id = 0;
  };
  // Returns the ends of the body beyond a joint.
  std::vector<End> EndsBeyond(JointIndex joint) const;
  // Adds the two contact points of an end along a normal, each with half of the weight.
  static void AddSides(const End& end, const PlacedFrame& placed, const Vec3& normal, double weight,
                       std::vector<ContactPoint>* points);

 private:
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
