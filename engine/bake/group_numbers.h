#pragma once

#include <vector>

#include "engine/passive/region_dynamics.h"

namespace hazumi {

// A group of joints that feel each other, and how accurately it is to be solved.
struct GroupTask {
  RegionModel model;
  VecX friction, lower, upper;  // by free hinge: rates [1/s], stops [rad]
  double gravity;               // along -z [m/s^2]
  double step_tolerance;
};

// What a group is asked and what it answers, as numbers: they can be compared, bit by bit.
using Numbers = std::vector<double>;

// What a question begins with, and its arguments:
enum class GroupCall {
  kBegin,    // t, end, angles, rates, curves, task
  kDrive,    // t, end, curves
  kFeelPin,  // v_pin
  kAdvance,  // t, end: steps until it is beyond t
  kAhead,    // end, times: all steps
  kSample,   // t
  kEnergy,   // t
};

// What the answers to kAdvance and kAhead begin with; as many hits follow, each as its hinge, times
// and count, and for kAhead samples at the times. A sample is angles and rates of the free hinges.
struct GroupProgress {
  enum { kTime, kStepStart, kStuckHinge, kCause, kMicroseconds, kNumHits, kHits };
  static constexpr int kHitSize = 4;
};

template <typename Derived>
void Append(const Eigen::MatrixBase<Derived>& values, Numbers* numbers) {
  for (const double value : values.reshaped()) numbers->push_back(value);
}

// Everything that a solution depends on but the arguments before it.
void AppendTask(const GroupTask& task, Numbers* numbers);

// The curves that the first nodes of the model read, and the root's.
void AppendCurves(const RegionModel& model, size_t num_nodes, const DrivenMotion& driven,
                  Numbers* numbers);
void ReadCurves(const RegionModel& model, const double* numbers, DrivenMotion* driven);

// Everything that the motion of the node which carries a group depends on, from t to `end`; the
// nodes before first_moved move it.
Numbers AttachmentKey(const RegionModel& model, int first_moved, double gravity,
                      const DrivenMotion& driven, double t, double end);

}  // namespace hazumi
