#pragma once

#include <vector>

#include "engine/analysis/frame_dynamics.h"
#include "engine/bake/motion.h"

namespace hazumi {

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

  // Stays until four other frames have been asked for.
  MovedFrame At(size_t frame);

 private:
  void Differentiate(double h);

  const Motion& motion_;
  double end_;
  EffortKernels kernels_ = BestEffortKernels();
  // Filtered, by frame: angles, position, quaternion; their rates and accelerations; and the root.
  MatX series_, rates_, accelerations_;
  std::vector<Pose> X_WR_;
  std::vector<RootMotion> root_;
  MotionAcceleration found_[4];
};

}  // namespace hazumi
