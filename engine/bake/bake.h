#pragma once

#include <atomic>
#include <limits>
#include <optional>

#include "engine/bake/motion.h"
#include "engine/base/result.h"
#include "engine/timeline/animation.h"

namespace hazumi {

struct BakeOptions {
  // Frames a second of the result; the animation's own if not given. The motion is the same: the
  // steps of the solver lie on the animation's frames, other instants are found between them.
  std::optional<FrameRate> output_rate;
  // Set by another thread or a signal: the bake ends within a step (ErrorCode::kInterrupted).
  const std::atomic<bool>* cancel = nullptr;
  // Account for the energy of exact regions in their reports; takes about as long again.
  bool energy = false;
  // So many threads at most solve islands of joints that do not feel each other; 0: as many as the
  // machine has. The motion is the same.
  int threads = 0;
  // False: the motion has no frames, only events, reports and warnings. It takes no memory then
  // that grows with the frames.
  bool keep_frames = true;
  // Say what jumps where regions, placements and holds begin and end: Motion::seams.
  bool seams = false;
  // Say each frame's accelerations: MotionFrame::acceleration.
  bool accelerations = false;
  // Solve exact regions again, with finer steps, where their error estimates miss their tolerances.
  bool refine = true;
  // Work limit of exact regions (Work). A bake that reaches the limit ends early, with a warning
  // that names the frame.
  double most_work = std::numeric_limits<double>::infinity();
};

// Computes the motion of an animation. Fails (ErrorCode::kSemantics, naming joint, frame and cause)
// where a hold is out of reach or a region cannot go on, before it begins where it would take too
// much memory or too many steps (bake_size.h), and with kFailed where the machine has not enough
// memory. Two bakes of one animation are bit-equal.
Result<Motion> Bake(const Animation& animation, const BakeOptions& options = {});

}  // namespace hazumi
