#pragma once

#include <vector>

#include "engine/bake/motion.h"

namespace hazumi {

// Where the figure is in a frame, how fast and how much faster it gets.
struct MovedFrame {
  const MotionLimit* limit = nullptr;
  const MotionAcceleration* acceleration = nullptr;
};

// A motion with the accelerations of all its frames: its own, or, filtered, those of what is left
// of it below a cutoff.
class SmoothMotion {
 public:
  // The motion must outlive it. At `end`, where the animation ends, all that is known comes from
  // the left [s].
  SmoothMotion(const Motion& motion, double end) : motion_(motion), end_(end) {}

  // Takes what is faster than the cutoff [Hz] out of angles and root, and differentiates what is
  // left. False, and nothing done, where frames are too few or too far apart for that.
  bool Filter(double cutoff);

  // Stays until the next call.
  MovedFrame At(size_t frame);

 private:
  const Motion& motion_;
  double end_;
  std::vector<MotionLimit> limits_;                // filtered
  std::vector<MotionAcceleration> accelerations_;  // of these
  MotionAcceleration found_;
};

}  // namespace hazumi
