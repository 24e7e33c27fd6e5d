// Filtered: angles (without whole turns), the root's position, and its rotation as a quaternion on
// the side of the one before, all through LowPass; then with frames h apart
//   x' = (x_(n+1) - x_(n-1)) / (2 h),   x'' = (x_(n+1) - 2 x_n + x_(n-1)) / h^2,
// and for rotations, with r(A, B) the turn from A to B,
//   w  = (r(R_n, R_(n+1)) + r(R_(n-1), R_n)) / (2 h),   w' = (r(R_n, R_(n+1)) - r(R_(n-1), R_n)) /
//   h^2.
// The first and the last frame take the rates and accelerations of their neighbours.

#include "engine/analysis/smooth_motion.h"

#include <Eigen/Geometry>
#include <numbers>

#include "engine/spatial/degrees.h"
#include "engine/spatial/pose.h"

namespace hazumi {

namespace {

// Whether some angle is nearer with whole turns more or less.
bool HasTurned(const Eigen::Ref<const VecX>& now, const Eigen::Ref<const VecX>& before) {
  return (now - before).lpNorm<Eigen::Infinity>() >= std::numbers::pi;
}

// By frame: angles, position, quaternion.
MatX SeriesOf(const Motion& motion) {
  const Eigen::Index n = motion.frames[0].q.size();
  MatX series(n + 7, static_cast<Eigen::Index>(motion.frames.size()));
  Eigen::Vector4d last = Eigen::Vector4d::Zero();
  for (Eigen::Index i = 0; i < series.cols(); ++i) {
    const MotionFrame& frame = motion.frames[static_cast<size_t>(i)];
    series.col(i).head(n) = frame.q;
    if (i > 0 && HasTurned(series.col(i).head(n), series.col(i - 1).head(n))) {
      for (Eigen::Index j = 0; j < n; ++j) series(j, i) = NearestTurn(frame.q[j], series(j, i - 1));
    }
    series.col(i).segment<3>(n) = frame.X_WR.p;
    Eigen::Vector4d turn = Eigen::Quaterniond(frame.X_WR.R).coeffs();
    if (turn.dot(last) < 0.0) turn = -turn;
    series.col(i).tail<4>() = last = turn;
  }
  return series;
}

}  // namespace

bool SmoothMotion::Filter(double cutoff) {
  constexpr size_t kFewest = 8;   // frames
  constexpr double kMost = 0.25;  // cutoff as a share of the frame rate
  const double h = motion_.rate.seconds_per_frame();
  const size_t count = motion_.frames.size();
  if (count < kFewest || cutoff * h > kMost) return false;
  series_ = SeriesOf(motion_);
  LowPass(cutoff, h, &series_, kernels_);
  Differentiate(h);
  return true;
}

void SmoothMotion::Differentiate(double h) {
  const Eigen::Index rows = series_.rows(), n = rows - 7, count = series_.cols();
  rates_.resize(rows, count);
  accelerations_.resize(rows, count);
  kernels_.differentiate(series_.col(1).data(), rows * (count - 2), rows, h, rates_.col(1).data(),
                         accelerations_.col(1).data());
  X_WR_.resize(static_cast<size_t>(count));
  root_.resize(static_cast<size_t>(count));
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Vector4d turn = series_.col(i).tail<4>();
    X_WR_[i] = {Eigen::Quaterniond(turn).normalized().toRotationMatrix(),
                series_.col(i).segment<3>(n)};
  }
  Vec3 before = TurnBetween(X_WR_[0].R, X_WR_[1].R);
  for (Eigen::Index i = 1; i + 1 < count; ++i) {
    const Vec3 after = TurnBetween(X_WR_[i].R, X_WR_[i + 1].R);
    root_[i] = {(after + before) / (2.0 * h), rates_.col(i).segment<3>(n),
                (after - before) / (h * h), accelerations_.col(i).segment<3>(n)};
    before = after;
  }
  for (const auto& [end, neighbour] :
       {std::pair(Eigen::Index(0), Eigen::Index(1)), {count - 1, count - 2}}) {
    rates_.col(end) = rates_.col(neighbour);
    accelerations_.col(end) = accelerations_.col(neighbour);
    root_[end] = root_[neighbour];
  }
}

MovedFrame SmoothMotion::At(size_t frame) {
  if (!root_.empty()) {
    const auto column = static_cast<Eigen::Index>(frame);
    return {&X_WR_[frame], series_.col(column).data(), rates_.col(column).data(),
            accelerations_.col(column).data(), root_[frame]};
  }
  const MotionFrame& own = motion_.frames[frame];
  const MotionAcceleration* by = own.acceleration ? &*own.acceleration : &found_[frame % 4];
  bool is_end = frame + 1 == motion_.frames.size();
  if (own.acceleration) {
    constexpr double kSame = 1e-9;  // [s]
    is_end = motion_.rate.SecondsAt(own.frame) >= end_ - kSame;
  } else {
    found_[frame % 4] = AccelerationAt(motion_, frame);
  }
  const MotionLimit& at = is_end ? own.before : own.after;
  return {&at.X_WR,
          at.q.data(),
          at.qd.data(),
          by->qdd.data(),
          {at.root_w, at.root_v, by->root_alpha, by->root_a}};
}

}  // namespace hazumi
