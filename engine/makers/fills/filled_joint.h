#pragma once

// Internal. A joint that is filled: which of its frames are keys, and how it turns.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/figure/figure.h"
#include "engine/figure/hinge_row.h"
#include "engine/project/project.h"
#include "engine/solve/chain.h"
#include "engine/timeline/animation.h"

namespace hazumi::makers {

// Concentric hinges, or the root's turn.
struct FilledJoint {
  std::optional<GroupIndex> group;  // none: the root
  // Curves of the hinges, from the parent out.
  std::vector<std::string> curves;
  std::vector<const Keys*> keys_of;
  std::vector<double> rest;        // without keys [rad]
  HingeRow row;                    // axes in the frame before it
  Mat3 behind = Mat3::Identity();  // its turn when all angles are 0
  // Range of each hinge: its limits, extended by its keys [rad].
  std::vector<double> lower, upper;

  // Frames of its motion, in the fill: each hinge that has keys has one before or on the first and
  // one on or behind the last.
  int first = 0, last = 0;
  std::vector<char> is_known;  // by frame from `first` on: it has a key there, or no smooth curve
  bool is_free_before = false, is_free_after = false;  // ends of its motion
  std::vector<char> has_steps;  // by hinge: parts of its curve hold, are linear or eased
  std::map<int, std::vector<double>> at_limit;  // by frame: its angles where a limit stops it

  // Rotation against the body before it [rad].
  Mat3 TurnOf(const std::vector<double>& angles) const { return RotationOf(row, angles) * behind; }
  bool IsKnown(int frame) const {
    return frame < first || frame > last || is_known[static_cast<size_t>(frame - first)] != 0;
  }
  bool IsKeyed(int frame) const { return IsKnown(frame) && !at_limit.contains(frame); }
  bool IsWithinLimits(const std::vector<double>& angles) const {
    constexpr double kRounding = 1e-9;  // [rad]
    for (size_t i = 0; i < angles.size(); ++i) {
      if (angles[i] < lower[i] - kRounding || angles[i] > upper[i] + kRounding) return false;
    }
    return true;
  }
  void ForgetLimits() {
    for (const auto& [frame, angles] : at_limit) is_known[static_cast<size_t>(frame - first)] = 0;
    at_limit.clear();
  }
};

// Joint of a fill; none if a hinge has keys, but fewer than two in the fill, or if no hinge has
// any. Errors: kSchema for a key between frames.
Result<std::optional<FilledJoint>> FilledJointOf(std::optional<GroupIndex> group,
                                                 const ProjectFill& fill,
                                                 const Animation& animation);

// Motion of a joint from the frame before its first key to the one after its last key. These two
// say how it arrives and leaves: as its curve there, which rests before all keys and after them, or
// with the rate of that key.
struct JointTurns {
  std::vector<solve::TurnAxis> axes;    // about which it may turn
  std::vector<Mat3> turns;              // by frame, from first - 1 on
  std::vector<solve::GivenRate> rates;  // of its keys inside, with frames counted from first - 1

  Mat3& At(int frame, const FilledJoint& joint) { return turns[frame - joint.first + 1]; }
};
// Motion of its curves; where it turns about one axis from key to key it stays on that one.
JointTurns TurnsOfCurves(const FilledJoint& joint, FrameRate rate);

// Values of a curve at frames in a row, with nothing else that moves it.
std::vector<double> SampleCurve(const Keys& keys, double rest, int first, int last, FrameRate rate);
// Values from the frame before `first` to the one after `last`, as JointTurns has them.
std::vector<double> SampleAround(const Keys& keys, double rest, int first, int last,
                                 FrameRate rate);

}  // namespace hazumi::makers
