// Filtered: angles (without whole turns), the root's position, and its rotation as a quaternion on
// the side of the one before, all through LowPass; then with frames h apart
//   x' = (x_(n+1) - x_(n-1)) / (2 h),   x'' = (x_(n+1) - 2 x_n + x_(n-1)) / h^2,
// and for rotations, with r(A, B) the turn from A to B,
//   w  = (r(R_n, R_(n+1)) + r(R_(n-1), R_n)) / (2 h),   w' = (r(R_n, R_(n+1)) - r(R_(n-1), R_n)) /
//   h^2.
// The first and the last frame take the accelerations of their neighbours.

#include "engine/analysis/smooth_motion.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "engine/analysis/joint_torques.h"
#include "engine/analysis/low_pass.h"
#include "engine/spatial/degrees.h"
#include "engine/spatial/turn.h"

namespace hazumi {

namespace {

// By frame: angles, position, quaternion.
MatX SeriesOf(const Motion& motion) {
  const Eigen::Index n = motion.frames[0].q.size();
  MatX series(n + 7, static_cast<Eigen::Index>(motion.frames.size()));
  Eigen::Vector4d last = Eigen::Vector4d::Zero();
  for (Eigen::Index i = 0; i < series.cols(); ++i) {
    const MotionFrame& frame = motion.frames[static_cast<size_t>(i)];
    for (Eigen::Index j = 0; j < n; ++j) {
      series(j, i) = i > 0 ? NearestTurn(frame.q[j], series(j, i - 1)) : frame.q[j];
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
  MatX series = SeriesOf(motion_);
  LowPass(cutoff, h, &series);
  const Eigen::Index n = series.rows() - 7;
  limits_.resize(count);
  accelerations_.resize(count);
  for (size_t i = 0; i < count; ++i) {
    const auto column = series.col(static_cast<Eigen::Index>(i));
    limits_[i].q = column.head(n);
    limits_[i].X_WR.p = column.segment<3>(n);
    limits_[i].X_WR.R =
        Eigen::Quaterniond(Eigen::Vector4d(column.tail<4>())).normalized().toRotationMatrix();
  }
  const auto differentiate = [&](size_t i, MotionLimit* limit, MotionAcceleration* found) {
    const MotionLimit &a = limits_[i - 1], &b = limits_[i], &c = limits_[i + 1];
    found->qdd = (c.q - 2.0 * b.q + a.q) / (h * h);
    found->root_a = (c.X_WR.p - 2.0 * b.X_WR.p + a.X_WR.p) / (h * h);
    const Vec3 before = TurnBetween(a.X_WR.R, b.X_WR.R), after = TurnBetween(b.X_WR.R, c.X_WR.R);
    found->root_alpha = (after - before) / (h * h);
    limit->qd = (c.q - a.q) / (2.0 * h);
    limit->root_v = (c.X_WR.p - a.X_WR.p) / (2.0 * h);
    limit->root_w = (after + before) / (2.0 * h);
  };
  for (size_t i = 0; i < count; ++i) {
    differentiate(std::clamp<size_t>(i, 1, count - 2), &limits_[i], &accelerations_[i]);
  }
  return true;
}

MovedFrame SmoothMotion::At(size_t frame) {
  if (!limits_.empty()) return {&limits_[frame], &accelerations_[frame]};
  const MotionFrame& own = motion_.frames[frame];
  if (own.acceleration) {
    constexpr double kSame = 1e-9;  // [s]
    const bool is_end = motion_.rate.SecondsAt(own.frame) >= end_ - kSame;
    return {is_end ? &own.before : &own.after, &*own.acceleration};
  }
  found_ = AccelerationAt(motion_, frame);
  const bool is_last = frame + 1 == motion_.frames.size();
  return {is_last ? &own.before : &own.after, &found_};
}

}  // namespace hazumi
