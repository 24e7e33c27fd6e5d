#include "engine/solve/chain.h"

#include "engine/solve/turn_vector.h"

namespace hazumi::solve {

namespace {

// P(f) = I f + s f x I f / 2, with s = 1 or -1, and its derivative.
struct Momentum {
  Vec3 value;
  Mat3 change;
};
Momentum MomentumOf(const Mat3& I, const Vec3& f, double s) {
  const Vec3 L = I * f;
  return {L + 0.5 * s * f.cross(L), I + 0.5 * s * (CrossMatrix(f) * I - CrossMatrix(L))};
}

}  // namespace

ChainUnknowns::ChainUnknowns(const Chain& chain) : first_{0} {
  for (const ChainJoint& joint : chain.joints) {
    first_.push_back(first_.back() + static_cast<int>(joint.axes.size()));
  }
}

Axes AxesBehind(const Mat3& turn, const ChainJoint& joint) {
  Axes axes(3, joint.axes.size());
  for (size_t i = 0; i < joint.axes.size(); ++i) {
    const TurnAxis& axis = joint.axes[i];
    axes.col(i) = axis.is_before ? Vec3(turn.transpose() * axis.axis) : axis.axis;
  }
  return axes;
}

Mat3 TurnedOn(const Mat3& turn, const ChainJoint& joint, const Eigen::Ref<const VecX>& by) {
  Vec3 before = Vec3::Zero(), behind = Vec3::Zero();
  for (size_t i = 0; i < joint.axes.size(); ++i) {
    (joint.axes[i].is_before ? before : behind) += by[i] * joint.axes[i].axis;
  }
  return RotationBy(before) * turn * RotationBy(behind);
}

ChainPose PoseOfChain(const Chain& chain, int frame, const std::vector<Mat3>& turns) {
  ChainPose pose;
  pose.bodies.reserve(chain.joints.size());
  const Pose& carrier = chain.carrier[static_cast<size_t>(frame)];
  const Mat3* W = &carrier.R;
  Vec3 o = carrier.p;
  for (size_t k = 0; k < chain.joints.size(); ++k) {
    const RigidInertia& own = chain.bodies[static_cast<size_t>(frame)][k];
    ChainPose::Body body;
    body.o = o + *W * chain.joints[k].offset;
    body.W = *W * turns[k];
    body.g = body.o + body.W * own.com;
    body.axes = body.W * AxesBehind(turns[k], chain.joints[k]);
    pose.bodies.push_back(std::move(body));
    W = &pose.bodies.back().W;
    o = pose.bodies.back().o;
  }
  return pose;
}

ChainMoments::ChainMoments(const Chain& chain, int frame, const ChainPose& before,
                           const ChainPose& now, const ChainPose& after)
    : chain_(chain), frame_(frame), before_(&before), now_(&now), after_(&after) {
  const size_t n = chain.joints.size();
  own_.reserve(n);
  for (size_t k = 0; k < n; ++k) own_.push_back(ForcesOn(k));
  if (chain.falling_mass > 0.0) TakeFall();
  sums_.resize(n);
  for (size_t k = n; k-- > 0;) {
    const ChainPose::Body& body = now.bodies[k];
    Sums& sums = sums_[k];
    sums = {own_[k].F, own_[k].N + (body.g - body.o).cross(own_[k].F)};
    if (k + 1 == n) continue;
    sums.moment += sums_[k + 1].moment + (now.bodies[k + 1].o - body.o).cross(sums_[k + 1].force);
    sums.force += sums_[k + 1].force;
  }
}

ChainMoments::OwnForces ChainMoments::ForcesOn(size_t k) const {
  const RigidInertia& body = chain_.bodies[static_cast<size_t>(frame_)][k];
  if (body.is_massless()) return {};
  const ChainPose::Body &a = before_->bodies[k], &x = now_->bodies[k], &z = after_->bodies[k];
  const double per_step2 = 1.0 / (chain_.step * chain_.step);
  OwnForces own;
  own.F = body.mass * ((z.g - 2.0 * x.g + a.g) * per_step2 - chain_.gravity);
  own.f1 = TurnVector(a.W.transpose() * x.W);
  own.f2 = TurnVector(x.W.transpose() * z.W);
  own.V1 = TurnVectorChange(own.f1);
  own.V2 = TurnVectorChange(own.f2);
  const Momentum P = MomentumOf(body.I_com, own.f2, 1.0), Q = MomentumOf(body.I_com, own.f1, -1.0);
  own.P = P.change;
  own.Q = Q.change;
  own.N = x.W * (P.value - Q.value) * per_step2;
  return own;
}

void ChainMoments::TakeFall() {
  const auto& bodies = chain_.bodies[static_cast<size_t>(frame_)];
  Vec3 asked = chain_.fall[static_cast<size_t>(frame_)];
  for (size_t k = 0; k < own_.size(); ++k) asked -= own_[k].F + bodies[k].mass * chain_.gravity;
  levers_.resize(own_.size());
  double mass = 0.0;
  Vec3 moment = Vec3::Zero();  // sum of m_k g_k
  for (size_t k = own_.size(); k-- > 0;) {
    own_[k].F += bodies[k].mass / chain_.falling_mass * asked;
    mass += bodies[k].mass;
    moment += bodies[k].mass * now_->bodies[k].g;
    levers_[k] = moment - mass * now_->bodies[k].o;
  }
}

VecX ChainMoments::Torques(int joint) const {
  const size_t j = static_cast<size_t>(joint);
  return now_->bodies[j].axes.transpose() * sums_[j].moment;
}

ChainMoments::Sums ChainMoments::Change(int at, size_t joint, const Vec3& u, size_t k) const {
  if (chain_.bodies[static_cast<size_t>(frame_)][k].is_massless()) return {};
  const double per_step2 = 1.0 / (chain_.step * chain_.step);
  const ChainPose& moved = at < 0 ? *before_ : at > 0 ? *after_ : *now_;
  const ChainPose::Body& body = moved.bodies[k];
  const Vec3 dg = u.cross(body.g - moved.bodies[joint].o);
  const OwnForces& own = own_[k];
  const double mass = chain_.bodies[static_cast<size_t>(frame_)][k].mass;
  const Mat3& W = now_->bodies[k].W;
  const Vec3 v = body.W.transpose() * u;  // in the body's frame
  Sums change;
  change.force = (at == 0 ? -2.0 : 1.0) * mass * per_step2 * dg;
  if (at < 0) {
    change.moment = W * (own.Q * (own.V1.transpose() * v)) * per_step2;
  } else if (at > 0) {
    change.moment = W * (own.P * (own.V2 * v)) * per_step2;
  } else {
    const Vec3 dL = own.P * (own.V2.transpose() * v) + own.Q * (own.V1 * v);
    change.moment = u.cross(own.N) - W * dL * per_step2;
  }
  return change;
}

void ChainMoments::Differentiate(int at, int joint, int axis, const ChainUnknowns& unknowns,
                                 Eigen::Ref<VecX> change) {
  const ChainPose& moved = at < 0 ? *before_ : at > 0 ? *after_ : *now_;
  const size_t i = static_cast<size_t>(joint);
  const Vec3 u = moved.bodies[i].axes.col(axis);
  Vec3 fall = Vec3::Zero();  // change of s''
  if (!levers_.empty()) {
    for (size_t k = i; k < own_.size(); ++k) fall -= Change(at, i, u, k).force;
    fall /= chain_.falling_mass;
  }
  Sums sums;
  for (size_t k = chain_.joints.size(); k-- > 0;) {
    const ChainPose::Body& body = now_->bodies[k];
    const bool turns = at == 0 && k >= i;  // the body's levers turn, too
    if (k + 1 < chain_.joints.size()) {
      const Vec3 lever = now_->bodies[k + 1].o - body.o;
      sums.moment += lever.cross(sums.force);
      if (turns) sums.moment += u.cross(lever).cross(sums_[k + 1].force);
    }
    if (k >= i) {
      const Sums own = Change(at, i, u, k);
      const Vec3 lever = body.g - body.o;
      sums.force += own.force;
      sums.moment += own.moment + lever.cross(own.force);
      if (turns) sums.moment += u.cross(lever).cross(own_[k].F);
    }
    const int j = static_cast<int>(k), first = unknowns.first(j);
    for (int e = 0; e < unknowns.size(j); ++e) {
      const Vec3& b = body.axes.col(e);
      double& entry = change[first + e];
      entry = b.dot(sums.moment);
      if (!levers_.empty()) entry += b.dot(levers_[k].cross(fall));
      const bool is_turned = k > i || !chain_.joints[k].axes[static_cast<size_t>(e)].is_before;
      if (turns && is_turned) entry += u.cross(b).dot(sums_[k].moment);
    }
  }
}

std::vector<MatX> CarriedInertias(const Chain& chain, int frame, const ChainPose& pose) {
  const auto& bodies = chain.bodies[static_cast<size_t>(frame)];
  std::vector<MatX> carried(bodies.size());
  for (size_t j = 0; j < bodies.size(); ++j) {
    Mat3 I = Mat3::Zero();
    for (size_t k = j; k < bodies.size(); ++k) {
      const ChainPose::Body& body = pose.bodies[k];
      I += body.W * bodies[k].I_com * body.W.transpose() +
           PointInertia(bodies[k].mass, body.g - pose.bodies[j].o);
    }
    carried[j] = pose.bodies[j].axes.transpose() * I * pose.bodies[j].axes;
  }
  return carried;
}

}  // namespace hazumi::solve
