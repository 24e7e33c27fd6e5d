#include "engine/analysis/placed_frames.h"

#include <algorithm>
#include <cmath>

#include "engine/spatial/lanes/cpu.h"

namespace hazumi {

namespace {

PlacedHinge PrepareHinge(const Joint& joint) {
  PlacedHinge hinge;
  hinge.parent = joint.parent.is_valid() ? joint.parent.value() + 1 : 0;
  hinge.is_parallel = joint.parallel_frame;
  hinge.is_shifted = !joint.X_PJ.p.isZero(0.0);
  hinge.is_massless = joint.massless;
  for (int k = 0; k < 3; ++k) {
    if (std::abs(joint.axis[k]) != 1.0) continue;
    hinge.unit_axis = k;
    hinge.sign = joint.axis[k];
  }
  std::copy_n(joint.X_PJ.R.data(), 9, hinge.R_PJ);
  std::copy_n(joint.X_PJ.p.data(), 3, hinge.p_PJ);
  std::copy_n(joint.axis.data(), 3, hinge.axis);
  return hinge;
}

}  // namespace

EffortKernels BestEffortKernels() {
  return CpuHasAvx2() ? Avx2EffortKernels() : BaselineEffortKernels();
}

PlacedFrames::PlacedFrames(const Figure& figure, size_t num_frames, const EffortKernels& kernels)
    : kernels_(kernels),
      stride_(4 * kPlacedFields * (static_cast<size_t>(figure.num_joints()) + 1)),
      placed_(LaneArray::Unset((num_frames + 3) / 4 * stride_)) {
  for (const Joint& joint : figure.joints()) hinges_.push_back(PrepareHinge(joint));
}

const double* PlacedFrames::Add(const Pose& X_WR, const double* q) {
  const size_t lane = num_added_ % 4;
  double* root = placed_.data() + num_added_ / 4 * stride_ + lane;
  for (int i = 0; i < 9; ++i) root[4 * i] = X_WR.R.data()[i];
  for (int i = 0; i < 3; ++i) root[36 + 4 * i] = X_WR.p[i];
  angles_[lane] = q;
  ++num_added_;
  return lane == 3 ? PlaceLastFour() : nullptr;
}

// Lanes without a frame do what the last frame does, at the world's origin.
const double* PlacedFrames::Finish() {
  const size_t last = num_added_ % 4;
  if (last == 0) return nullptr;
  double* root = placed_.data() + num_added_ / 4 * stride_;
  for (int i = 0; i < kPlacedFields; ++i) std::fill(root + 4 * i + last, root + 4 * (i + 1), 0.0);
  std::fill(angles_ + last, angles_ + 4, angles_[last - 1]);
  return PlaceLastFour();
}

const double* PlacedFrames::PlaceLastFour() {
  double* four = placed_.data() + (num_added_ - 1) / 4 * stride_;
  kernels_.place(hinges_.data(), static_cast<int>(hinges_.size()), angles_, four);
  return four;
}

}  // namespace hazumi
