#pragma once

// Internal. From rotations of a filled joint to the angles of its hinges.

#include <optional>
#include <vector>

#include "engine/makers/fills/filled_joint.h"

namespace hazumi::makers {

// Keeps angles, by frame from `first` on, within the limits. Where the joint cannot turn that way
// it stops as near as it can, and is known there from now on. A ball joint whose other triple of
// angles is within them keeps its turn, and its angles, which go on through the pole. False if it
// stops nowhere new.
bool StopAtLimits(FilledJoint* joint, std::vector<std::vector<double>>* angles);

// Change of a ball joint from one triple of angles to another of the same rotation, half-way from a
// frame to the next.
struct TripleChange {
  int frame = 0;
  std::vector<double> before, after;            // [rad]
  std::vector<double> rate_before, rate_after;  // [rad a frame]
};
struct JointAngles {
  std::vector<std::vector<double>> by_frame;  // from the joint's first key on [rad]
  std::vector<TripleChange> changes;
};
// Angles of its turns from its first key to its last, each near the one before, and on known frames
// those of its keys. None: they turn another number of times than its keys do.
std::optional<JointAngles> AnglesOfTurns(const FilledJoint& joint, const JointTurns& motion,
                                         FrameRate rate);

}  // namespace hazumi::makers
