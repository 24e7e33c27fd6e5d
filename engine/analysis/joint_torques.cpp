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

#include <Eigen/Geometry>

#include "engine/bake/pose/held_objects.h"
#include "engine/dynamics/kinematics.h"

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

Vec3 TurnBetween(const Mat3& from, const Mat3& to) {
  const Eigen::AngleAxisd turn(to * from.transpose());
  return turn.angle() * turn.axis();
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

// A figure with what it holds at some frame.
class LoadedFigure {
 public:
  LoadedFigure(const Animation& animation, const MotionFrame& frame)
      : held_(HeldAt(frame)),
        figure_(Loaded(animation, held_)),
        dynamics_(figure_),
        scratch_(dynamics_.MakeScratch()),
        ws_(figure_) {}

  bool IsThatOf(const MotionFrame& frame) const { return held_ == HeldAt(frame); }

  JointTorques Torques(const MotionLimit& at, const Accelerations& by, double gravity,
                       std::optional<GroupIndex> pin) {
    RootMotion root = by.root;
    root.a.z() += gravity;
    JointTorques found{VecX(figure_.num_joints()), {}};
    dynamics_.InverseDynamics(at.X_WR, root, at.q, at.qd, by.qdd, nullptr, &scratch_, &found.tau);
    found.unsupported = dynamics_.RootWrench(at.X_WR, root, scratch_);
    if (pin) PutOnPin(figure_.group(*pin).last(), at, &found);
    return found;
  }

 private:
  static std::vector<int> HeldAt(const MotionFrame& frame) {
    std::vector<int> held;
    for (const ObjectPose& object : frame.objects) held.push_back(object.holder);
    return held;
  }
  static Figure Loaded(const Animation& animation, const std::vector<int>& held) {
    Figure figure = *animation.figure;
    for (size_t i = 0; i < held.size(); ++i) {
      figure = WithObject(figure, animation.held_objects[i], held[i]);
    }
    return figure;
  }

  // What is beyond the pinned joint stands there: the joint's hinges carry the rest.
  void PutOnPin(JointIndex pinned, const MotionLimit& at, JointTorques* torques) {
    ComputePositions(figure_, at.X_WR, at.q, &ws_);
    const Vec3 p = ws_.body(pinned).p, f = torques->unsupported.force;
    const Vec3 n = torques->unsupported.moment - (p - at.X_WR.p).cross(f);
    for (int i = 0; i < figure_.num_joints(); ++i) {
      const JointIndex hinge(i);
      if (hinge != pinned && !figure_.IsBeyond(pinned, hinge)) continue;
      const BodyScratch& body = ws_.body(hinge);
      torques->tau[i] -= body.axis.dot(n + (p - body.p).cross(f));
    }
    torques->unsupported = {};
  }

  std::vector<int> held_;
  Figure figure_;
  FigureDynamics dynamics_;
  FigureScratch scratch_;
  DynamicsWorkspace ws_;
};

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
  std::vector<JointTorques> found;
  found.reserve(motion.frames.size());
  std::optional<LoadedFigure> figure;
  for (size_t i = 0; i < motion.frames.size(); ++i) {
    const MotionFrame& frame = motion.frames[i];
    if (!figure || !figure->IsThatOf(frame)) figure.emplace(animation, frame);
    const bool is_last = i + 1 == motion.frames.size();
    found.push_back(figure->Torques(is_last ? frame.before : frame.after, AtFrame(motion, i),
                                    animation.gravity, frame.pinned));
  }
  return found;
}

}  // namespace hazumi
