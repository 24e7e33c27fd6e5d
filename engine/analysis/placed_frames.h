#pragma once

#include <vector>

#include "engine/analysis/lanes/effort_kernels.h"
#include "engine/figure/figure.h"
#include "engine/spatial/lanes/lane_array.h"

namespace hazumi {

// Where a figure's bodies are in a frame, in the world: what ComputePositions finds. Joints that
// are not valid stand for the root.
class PlacedFrame {
 public:
  explicit PlacedFrame(const double* at) : at_(at) {}

  Vec3 p(JointIndex j) const { return Fields(j, 9); }  // joint origin [m]
  // A vector of a body's frame, in the world's.
  Vec3 Turned(JointIndex j, const Vec3& v) const {
    return v.x() * Fields(j, 0) + v.y() * Fields(j, 3) + v.z() * Fields(j, 6);
  }
  // Where a point of a body is [m].
  Vec3 PointOf(JointIndex j, const Vec3& offset) const { return p(j) + Turned(j, offset); }

 private:
  Vec3 Fields(JointIndex j, int first) const {
    const double* at = at_ + 4 * (kPlacedFields * (j.value() + 1) + first);
    return {at[0], at[4], at[8]};
  }
  const double* at_;  // by body and field, a lane of four
};

// Where they are in all frames of a motion, four of which are placed at once.
class PlacedFrames {
 public:
  PlacedFrames(const Figure& figure, size_t num_frames,
               const EffortKernels& kernels = BestEffortKernels());

  // Frame by frame, in order; q, by joint, must stay until four have been placed [rad]. Returns
  // these four where this frame is the last of them, else null; behind the last frame, those that
  // were left. As the kernels have them.
  const double* Add(const Pose& X_WR, const double* q);
  const double* Finish();
  // Valid while this is.
  PlacedFrame operator[](size_t frame) const { return PlacedFrame(FourWith(frame) + frame % 4); }
  // All of the four frames that `frame` belongs to, and all hinges, as the kernels have them.
  const double* FourWith(size_t frame) const { return placed_.data() + frame / 4 * stride_; }
  const std::vector<PlacedHinge>& hinges() const { return hinges_; }

 private:
  const double* PlaceLastFour();

  EffortKernels kernels_;
  std::vector<PlacedHinge> hinges_;
  size_t stride_;     // numbers of four frames
  LaneArray placed_;  // by four frames, body, field, frame
  size_t num_added_ = 0;
  const double* angles_[4];  // of the last four frames
};

}  // namespace hazumi
