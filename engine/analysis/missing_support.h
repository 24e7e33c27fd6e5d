#pragma once

// Frames with a residual wrench: the keys ask for a force or moment that no contact supplies.

#include <string>
#include <vector>

#include "engine/analysis/effort.h"

namespace hazumi {

enum class SupportFault {
  kFloats,     // the figure has no contact and does not fall
  kPulled,     // the required force pulls the figure down
  kSlides,     // the required horizontal force exceeds friction
  kTips,       // the centre of mass is outside the support, and the figure does not topple
  kPushedOff,  // the zero-moment point is outside the support
  kTurned,     // any other residual moment
  kTurnsInAir  // the angular momentum changes in flight
};

// Consecutive frames whose residual wrench exceeds kMissing, with the frame of the largest one.
struct MissingSupport {
  SupportFault fault = SupportFault::kFloats;  // fault in the worst frame
  int first = 0, last = 0;                     // frames of the motion, both inclusive
  int worst = 0;                               // worst frame of the motion
  double force = 0.0;                          // residual force [N]
  double moment = 0.0;                         // residual moment about the centre of mass [N m]
  double distance = 0.0;                       // kTips, kPushedOff: distance from the support [m]
  JointIndex joint;                            // kTips, kPushedOff: joint of the body at the edge
};

// Threshold as a share of the weight, or of the weight on an arm of the figure's size. The size is
// the distance from the root to the farthest joint of the rest pose.
inline constexpr double kMissing = 0.02;

// Returns the spans in order of frames. `effort` is that of the motion.
std::vector<MissingSupport> MissingSupports(const Animation& animation, const Motion& motion,
                                            const Effort& effort);

}  // namespace hazumi
