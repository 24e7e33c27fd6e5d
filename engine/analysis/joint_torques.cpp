// tau = Dinv(q, qd, qdd, a, 0, 0) [Arai (1)] with the whole figure hung on its root, which leaves a
// wrench F, N at the root's origin p_R. A pin at p, which holds
// the body beyond its joint, gives it instead: f = F and n = N - (p - p_R) x F,
// and each hinge i between root and pin, at p_i, is relieved of its part (principle of virtual
// work): tau_i -= axis_i . (n + (p - p_i) x f).
//
// Accelerations after a frame, from both ends of the frame's length h: of the cubic
//   qdd_0 = 6 (q_1 - q_0) / h^2 - (4 qd_0 + 2 qd_1) / h,   qdd_1 likewise from its end,
// and for the root's rotation of the cubic of r, with exp(r) = R_1 R_0^T:
//   r' = w at its beginning, r' = w - r x w / 2 + r x (r x w) / 12 + O(r^4) at its end.

#include "engine/analysis/joint_torques.h"

#include <algorithm>

#include "engine/analysis/frame_dynamics.h"
#include "engine/spatial/turn.h"

namespace hazumi {

namespace {

enum class At { kStart, kEnd };

template <typename Vector>
Vector CubicAcceleration(At at, const Vector& by, const Vector& rate_0, const Vector& rate_1,
                         double h) {
  return at == At::kStart ? Vector(6.0 / (h * h) * by - (4.0 * rate_0 + 2.0 * rate_1) / h)
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
Accelerations Between(const MotionLimit& start, const MotionLimit& end, double h, At at) {
  Accelerations found;
  found.qdd = CubicAcceleration<VecX>(at, end.q - start.q, start.qd, end.qd, h);
  const MotionLimit& now = at == At::kStart ? start : end;
  found.root.w = now.root_w;
  found.root.v = now.root_v;
  found.root.a =
      CubicAcceleration<Vec3>(at, end.X_WR.p - start.X_WR.p, start.root_v, end.root_v, h);
  const Vec3 r = TurnBetween(start.X_WR.R, end.X_WR.R);
  found.root.alpha =
      at == At::kStart
          ? CubicAcceleration<Vec3>(at, r, start.root_w, RateOfTurn(r, end.root_w), h)
          : CubicAcceleration<Vec3>(at, r, RateOfTurn(-r, start.root_w), end.root_w, h);
  return found;
}

// What is beyond the pinned joint stands there: the joint's hinges carry the rest.
void PutOnPin(size_t lane, JointIndex pinned, const PlacedFrame& placed, FrameDynamics* dynamics) {
  const Vec3 p = placed.p(pinned);
  Wrench of_pin = dynamics->needed(lane);
  of_pin.moment -= (p - placed.p(JointIndex())).cross(of_pin.force);
  dynamics->Push(lane, pinned, p, of_pin);
}

Accelerations AtFrame(const Motion& motion, size_t i) {
  const std::vector<MotionFrame>& frames = motion.frames;
  const auto between = [&](size_t a, At at) {
    const double h = motion.rate.SecondsAt(frames[a + 1].frame - frames[a].frame);
    return Between(frames[a].after, frames[a + 1].before, h, at);
  };
  if (i + 1 < frames.size()) return between(i, At::kStart);
  if (i > 0) return between(i - 1, At::kEnd);
  return {VecX::Zero(frames[i].q.size()), {}};
}

}  // namespace

MotionAcceleration AccelerationAt(const Motion& motion, size_t frame) {
  const Accelerations found = AtFrame(motion, frame);
  return {found.qdd, found.root.alpha, found.root.a};
}

std::vector<JointTorques> TorquesOf(const Animation& animation, const Motion& motion) {
  const size_t count = motion.frames.size();
  const auto limit_at = [&](size_t i) -> const MotionLimit& {
    return i + 1 == count ? motion.frames[i].before : motion.frames[i].after;
  };
  PlacedFrames placed(*animation.figure, count);
  for (size_t i = 0; i < count; ++i) placed.Add(limit_at(i).X_WR, limit_at(i).q.data());
  placed.Finish();
  FrameDynamics dynamics(animation, placed);
  std::vector<JointTorques> found(count);
  Accelerations by[4];
  for (size_t first = 0; first < count; first += 4) {
    for (size_t lane = 0; lane < 4; ++lane) {
      const size_t i = std::min(first + lane, count - 1);
      const MotionLimit& at = limit_at(i);
      by[lane] = AtFrame(motion, i);
      dynamics.Set(lane, motion.frames[i],
                   {&at.X_WR, at.q.data(), at.qd.data(), by[lane].qdd.data(), by[lane].root});
    }
    dynamics.Demand(first);
    const size_t lanes = std::min<size_t>(4, count - first);
    for (size_t lane = 0; lane < lanes; ++lane) {
      const std::optional<GroupIndex>& pinned = motion.frames[first + lane].pinned;
      if (pinned) {
        PutOnPin(lane, animation.figure->group(*pinned).last(), placed[first + lane], &dynamics);
      } else {
        found[first + lane].unsupported = dynamics.needed(lane);
      }
    }
    dynamics.FindTorques();
    for (size_t lane = 0; lane < lanes; ++lane) found[first + lane].tau = dynamics.torques(lane);
  }
  return found;
}

}  // namespace hazumi
