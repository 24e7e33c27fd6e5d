#pragma once

#include <vector>

#include "engine/analysis/effort_kernels.h"
#include "engine/dynamics/lane_plan.h"

namespace hazumi {

// Where a figure's bodies are in a frame, in the world: what ComputePositions finds. Joints that
// are not valid stand for the root.
class PlacedFrame {
 public:
  PlacedFrame(const PlacedHinge* hinges, const double* at) : hinges_(hinges), at_(at) {}

  Vec3 p(JointIndex j) const { return Fields(j, 9); }  // joint origin [m]
  // A vector of a body's frame, in the world's.
  Vec3 Turned(JointIndex j, const Vec3& v) const {
    return v.x() * Fields(j, 0) + v.y() * Fields(j, 3) + v.z() * Fields(j, 6);
  }
  // Where a point of a body is [m].
  Vec3 PointOf(JointIndex j, const Vec3& offset) const { return p(j) + Turned(j, offset); }
  Vec3 axis(JointIndex j) const {  // of the hinge, unit
    const PlacedHinge& hinge = hinges_[j.value()];
    if (hinge.unit_axis >= 0) return hinge.sign * Fields(j, 3 * hinge.unit_axis);
    return Turned(j, Vec3(hinge.axis[0], hinge.axis[1], hinge.axis[2]));
  }

 private:
  Vec3 Fields(JointIndex j, int first) const {
    const double* at = at_ + 4 * (kPlacedFields * (j.value() + 1) + first);
    return {at[0], at[4], at[8]};
  }
  const PlacedHinge* hinges_;  // by joint
  const double* at_;           // by body and field, a lane of four
};

// Where they are in all frames of a motion, four of which are placed at once.
class PlacedFrames {
 public:
  PlacedFrames(const Figure& figure, size_t num_frames,
               const EffortKernels& kernels = BestEffortKernels());

  // Frame by frame, in order; q must stay until Finish [rad]. True: four have been placed.
  bool Add(const Pose& X_WR, const VecX& q);
  bool Finish();
  // Those that were, as the kernels have them.
  const double* last_four() const { return placed_.data() + (num_added_ - 1) / 4 * stride_; }
  // Valid while this is.
  PlacedFrame operator[](size_t frame) const {
    return {hinges_.data(), placed_.data() + frame / 4 * stride_ + frame % 4};
  }

 private:
  // Of the four frames that `frame` belongs to.
  double* FourOf(size_t frame) { return placed_.data() + frame / 4 * stride_; }
  void PlaceLastFour();

  EffortKernels kernels_;
  std::vector<PlacedHinge> hinges_;
  size_t stride_;     // numbers of four frames
  LaneArray placed_;  // by four frames, body, field, frame
  size_t num_added_ = 0;
  const double* angles_[4];  // of the last four frames
};

}  // namespace hazumi
