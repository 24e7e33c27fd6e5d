#pragma once

// Frames in which a figure is carried, held back or turned by nothing.

#include <string>
#include <vector>

#include "engine/analysis/effort.h"

namespace hazumi {

enum class SupportFault {
  kFloats,     // nothing touches or grips, and it does not fall
  kPulled,     // it would have to be pulled down
  kSlides,     // it would have to be pushed sideways harder than friction does
  kTips,       // the centre of mass is beyond what it stands on, and it does not fall over
  kPushedOff,  // the ground would have to push from beyond what the figure stands on
  kTurned,     // some other moment is lacking
  kTurnsInAir  // it spins up or down in flight
};

// Frames in a row in which what comes from nowhere is more than kMissing, with the frame in which
// it is most.
struct MissingSupport {
  SupportFault fault = SupportFault::kFloats;  // in the worst frame, as all below
  int first = 0, last = 0;                     // frames of the motion, both inclusive
  int worst = 0;                               // frame of the motion
  double force = 0.0;                          // from nowhere [N]
  double moment = 0.0;                         // from nowhere, about the centre of mass [N m]
  double distance = 0.0;                       // kTips, kPushedOff: beyond the support [m]
  JointIndex joint;                            // kTips, kPushedOff: whose body is the edge there
};

// Share of the weight, or of the weight on an arm of the figure's size, which is the distance from
// the root to the farthest joint of the rest pose.
inline constexpr double kMissing = 0.02;

// `effort` is that of the motion. In order of frames.
std::vector<MissingSupport> MissingSupports(const Animation& animation, const Motion& motion,
                                            const Effort& effort);

// A sentence: when, what is lacking, and what to do.
std::string TextOf(const MissingSupport& missing, const Figure& figure);

}  // namespace hazumi
