#pragma once

// Accelerations of a motion whose bake did not report them: of its frames, or of what is left of it
// below a cutoff.

#include <vector>

#include "engine/analysis/frame_dynamics.h"
#include "engine/analysis/lanes/effort_kernels.h"
#include "engine/bake/motion.h"
#include "engine/spatial/types.h"

namespace hazumi {

// Returns the right-sided accelerations at a frame; at the last frame the left-sided ones. The
// accelerations are those of cubics through the angles and rates of two frames. They are exact
// where keys make the motion and each frame is a frame of the project; elsewhere their error is
// proportional to the square of the frame time. A motion of one frame has zero accelerations.
MotionAcceleration AccelerationAt(const Motion& motion, size_t frame);

// Takes what is faster than `cutoff` [Hz] out of series, one a row, with samples `dt` [s] apart in
// the columns; nothing is delayed. Series of one sample, and a cutoff that the samples cannot show
// (at or above half of their rate), are left as they are.
void LowPass(double cutoff, double dt, MatX* series,
             const EffortKernels& kernels = BestEffortKernels());

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
