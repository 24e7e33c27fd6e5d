// Accelerations after a frame, from both ends of the frame's length h: of the cubic
//   qdd_0 = 6 (q_1 - q_0) / h^2 - (4 qd_0 + 2 qd_1) / h,   qdd_1 likewise from its end,
// and for the root's rotation of the cubic of r, with exp(r) = R_1 R_0^T:
//   r' = w at its beginning, r' = w - r x w / 2 + r x (r x w) / 12 + O(r^4) at its end.

#include "engine/analysis/smooth_motion.h"
#include "engine/dynamics/kinematics.h"
#include "engine/spatial/pose.h"

namespace hazumi {

namespace {

enum class IntervalEnd { kStart, kEnd };

template <typename Vector>
Vector CubicAcceleration(IntervalEnd at, const Vector& by, const Vector& rate_0,
                         const Vector& rate_1, double h) {
  return at == IntervalEnd::kStart
             ? Vector(6.0 / (h * h) * by - (4.0 * rate_0 + 2.0 * rate_1) / h)
             : Vector(-6.0 / (h * h) * by + (2.0 * rate_0 + 4.0 * rate_1) / h);
}

// From the world axes at the start of a turn r to the rate of r.
Vec3 RateOfTurn(const Vec3& r, const Vec3& w) {
  return w - 0.5 * r.cross(w) + r.cross(r.cross(w)) / 12.0;
}

struct Accelerations {
  VecX qdd;
  RootMotion root;
};

// The angular acceleration at the end is found backwards in time from there, where r is zero.
Accelerations Between(const MotionLimit& start, const MotionLimit& end, double h, IntervalEnd at) {
  Accelerations found;
  found.qdd = CubicAcceleration<VecX>(at, end.q - start.q, start.qd, end.qd, h);
  const MotionLimit& now = at == IntervalEnd::kStart ? start : end;
  found.root.w = now.root_w;
  found.root.v = now.root_v;
  found.root.a =
      CubicAcceleration<Vec3>(at, end.X_WR.p - start.X_WR.p, start.root_v, end.root_v, h);
  const Vec3 r = TurnBetween(start.X_WR.R, end.X_WR.R);
  found.root.alpha =
      at == IntervalEnd::kStart
          ? CubicAcceleration<Vec3>(at, r, start.root_w, RateOfTurn(r, end.root_w), h)
          : CubicAcceleration<Vec3>(at, r, RateOfTurn(-r, start.root_w), end.root_w, h);
  return found;
}

Accelerations AtFrame(const Motion& motion, size_t i) {
  const std::vector<MotionFrame>& frames = motion.frames;
  const auto between = [&](size_t a, IntervalEnd at) {
    const double h = motion.rate.SecondsAt(frames[a + 1].frame - frames[a].frame);
    return Between(frames[a].after, frames[a + 1].before, h, at);
  };
  if (i + 1 < frames.size()) return between(i, IntervalEnd::kStart);
  if (i > 0) return between(i - 1, IntervalEnd::kEnd);
  return {VecX::Zero(frames[i].q.size()), {}};
}

}  // namespace

MotionAcceleration AccelerationAt(const Motion& motion, size_t frame) {
  const Accelerations found = AtFrame(motion, frame);
  return {found.qdd, found.root.alpha, found.root.a};
}

}  // namespace hazumi
