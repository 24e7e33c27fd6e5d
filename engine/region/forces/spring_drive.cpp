// Of a hinge, with I the inertia about it of what lies beyond when the region begins, w = 2 pi f:
//   tau = clamp(I (w^2 (q_ref - q) + 2 zeta w (q_ref' - q')), -most, most).
// Of a ball joint, with I the same about its centre, in the ball's frame, and E = R_ref^T R, the
// quaternion (eta, e), W the angular velocity relative to the reference:
//   U = 2 w^2 e.I e,   M = -2 w^2 (eta I e + (I e) x e) - 2 zeta w I W,
// which is -dU of any turn less the damper, and smooth through half a turn; scaled down to `most`,
// and into the ellipsoid whose half axes, along the ball's and by their sides, are what its muscles
// can give. Muscles of a hinge: -s S_-(q, q') <= tau <= s S_+(q, q').

#include "engine/region/forces/spring_drive.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/region/ball_axes.h"
#include "engine/region/forces/hinge_moment.h"

namespace hazumi {

using small::V3;

double RateOfFrequency(double frequency) { return 2.0 * std::numbers::pi * frequency; }

SpringNow NowOf(const Spring& spring, double frequency, double share) {
  return {spring.reads_frequency ? RateOfFrequency(frequency) : spring.rate,
          spring.reads_share ? share : spring.share};
}

HingePull PullOf(const Spring& spring, const SpringNow& now, const HingeMotion& hinge,
                 const HingeMotion& reference, double ahead) {
  const double w = now.rate;
  double pull = spring.inertia * w *
                (w * (reference.angle - hinge.angle) +
                 2.0 * spring.damping_ratio * (reference.rate - hinge.rate));
  if (spring.has_ahead) pull += ahead;
  if (!spring.muscles) return {pull, -spring.most, spring.most};
  const StrengthLimits limits = spring.muscles->At(hinge.angle, hinge.rate);
  return {pull, std::max(-spring.most, -now.share * limits.negative.torque),
          std::min(spring.most, now.share * limits.positive.torque)};
}

double TorqueOf(const Spring& spring, const SpringNow& now, const HingeMotion& hinge,
                const HingeMotion& reference, double ahead) {
  const HingePull own = PullOf(spring, now, hinge, reference, ahead);
  return std::clamp(own.pull, own.least, own.most);
}

Vec3 PullOf(const Spring& spring, const SpringNow& now, const Mat3& E, const Vec3& w,
            const Vec3& ahead) {
  const Eigen::Quaterniond turn(E);
  const Vec3 e = turn.vec(), Ie = spring.of_ball * e;
  const double rate = now.rate;
  Vec3 moment = -2.0 * rate * rate * (turn.w() * Ie + Ie.cross(e)) -
                2.0 * spring.damping_ratio * rate * (spring.of_ball * w);
  if (spring.has_ahead) moment += ahead;
  return moment;
}

double ExcessOf(const Spring& spring, const SpringNow& now, const Vec3& moment) {
  double sum = 0.0;
  for (int i = 0; i < 3; ++i) {
    const double whole = moment[i] >= 0.0 ? spring.most_forward[i] : spring.most_backward[i];
    const double most = std::isfinite(whole) ? now.share * whole : whole;
    sum += moment[i] == 0.0 ? 0.0 : (moment[i] / most) * (moment[i] / most);
  }
  return std::max(moment.norm() / spring.most, std::sqrt(sum));
}

namespace {

// Direction in which a hinge is pulled with all there is; 0: it is not.
int SideOfSpent(const HingePull& own) {
  return own.pull > own.most ? 1 : own.pull < own.least ? -1 : 0;
}

Vec3 Limited(const Spring& spring, const SpringNow& now, const Vec3& pull) {
  const double excess = spring.is_limited() ? ExcessOf(spring, now, pull) : 0.0;
  return excess > 1.0 ? Vec3(pull / excess) : pull;
}

}  // namespace

Vec3 MomentOf(const Spring& spring, const SpringNow& now, const Mat3& E, const Vec3& w,
              const Vec3& ahead) {
  return Limited(spring, now, PullOf(spring, now, E, w, ahead));
}

SpringNow SpringDrive::Now(int hinge, const RegionState& state) const {
  const Spring& spring = springs_[hinge];
  if (!spring.reads_frequency && !spring.reads_share) return {spring.rate, spring.share};
  const SpringCurves& curves = state.driven.springs[hinge];
  return NowOf(spring, curves.frequency.At(state.t).v, curves.share.At(state.t).v);
}

double SpringDrive::FastestRate() const {
  double fastest = 0.0;
  for (const Spring& spring : springs_) {
    fastest = std::max(fastest, spring.rate * std::max(1.0, 2.0 * spring.damping_ratio));
  }
  return fastest;
}

// Where it is turned to is told by how it lies beside its parent, whatever the layout.
SpringDrive::BallPull SpringDrive::PullOnBall(int node, const RegionState& state) const {
  const auto& hinges = state.model.nodes[node].hinges;
  const int first = state.layout.node(node).first_hinge;
  const NodeMotion& own = state.kinematics.motion()[node];
  const NodeMotion& parent = state.kinematics.motion()[state.model.nodes[node].parent];
  const Mat3 R_NB = BallFrame(hinges[0].axis, hinges[1].axis);
  const Mat3 R_WB = own.R.eigen() * R_NB;
  // The reference turns about the ball's axes one after the other; w_ref in the parent's frame.
  const Vec3 axes[3] = {Vec3::UnitX(), Vec3::UnitY(), R_NB.transpose() * hinges[2].axis};
  Mat3 R_ref = Mat3::Identity();
  Vec3 w_ref = Vec3::Zero();
  for (int k = 0; k < 3; ++k) {
    const Jet reference = state.driven.drives[first + k].At(state.t);
    w_ref += R_ref * (reference.d * axes[k]);
    Turn(axes[k], std::sin(reference.v), std::cos(reference.v), &R_ref);
  }
  const Mat3 R = (parent.R.eigen() * R_NB).transpose() * R_WB, E = R_ref.transpose() * R;
  const Vec3 w = R_WB.transpose() * (own.w - parent.w).eigen() - R.transpose() * w_ref;
  Vec3 ahead = Vec3::Zero();
  for (int k = 0; k < 3 && springs_[first].has_ahead; ++k) {
    ahead[k] = state.driven.springs[first + k].moment.At(state.t).v;
  }
  return {R_WB, E, w, PullOf(springs_[first], Now(first, state), E, w, ahead)};
}

V3 SpringDrive::MomentOnBall(int node, const RegionState& state) const {
  const int first = state.layout.node(node).first_hinge;
  const BallPull own = PullOnBall(node, state);
  return V3(Vec3(own.R_WB * Limited(springs_[first], Now(first, state), own.moment)));
}

template <typename Action>
void SpringDrive::ForEachHinge(int node, const RegionState& state, Action&& action) const {
  const RegionLayout::Node& own = state.layout.node(node);
  for (int h = 0, free = 0; free < own.num_dofs; ++h) {
    if (own.locked[h]) continue;
    const int hinge = own.first_hinge + h;
    if (springs_[hinge].rate > 0.0) {
      const Spring& spring = springs_[hinge];
      const Jet reference = state.driven.drives[hinge].At(state.t);
      const double ahead =
          spring.has_ahead ? state.driven.springs[hinge].torque.At(state.t).v : 0.0;
      const HingeMotion now = {state.positions[own.position + free],
                               state.velocities[own.dof + free]};
      const HingePull pull =
          PullOf(spring, Now(hinge, state), now, {reference.v, reference.d}, ahead);
      action(AtHinge{free, spring, pull, now, {reference.v - now.angle, reference.d - now.rate}});
    }
    ++free;
  }
}

V3 SpringDrive::MomentOnHinges(int node, const RegionState& state) const {
  double torques[3] = {};
  ForEachHinge(node, state, [&](const AtHinge& at) {
    torques[at.free] = std::clamp(at.pull.pull, at.pull.least, at.pull.most);
  });
  return MomentOfHinges(state.kinematics.motion()[node], state.layout.node(node).num_dofs, torques);
}

bool SpringDrive::Pulls(int node, const RegionState& state) const {
  if (state.layout.node(node).num_dofs == 0) return false;
  const auto first = springs_.begin() + state.layout.node(node).first_hinge;
  const auto pulls = [](const Spring& spring) { return spring.rate > 0.0; };
  return std::any_of(first, first + state.model.nodes[node].num_hinges, pulls);
}

void SpringDrive::AddForces(const RegionState& state, NodeKinematics* kinematics) const {
  const auto& nodes = state.layout.nodes();
  for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
    if (!Pulls(i, state)) continue;
    kinematics->AddJointMoment(
        i, state.model.nodes[i].is_ball ? MomentOnBall(i, state) : MomentOnHinges(i, state));
  }
}

// Returns the spring of a ball joint. A spring at its largest moment has no stiffness.
JointSpring SpringDrive::SpringOnBall(int node, const RegionState& state) const {
  const Spring& spring = springs_[state.layout.node(node).first_hinge];
  const SpringNow now = Now(state.layout.node(node).first_hinge, state);
  const BallPull own = PullOnBall(node, state);
  const bool is_spent = spring.is_limited() && ExcessOf(spring, now, own.moment) > 1.0;
  JointSpring all{node, own.R_WB * Limited(spring, now, own.moment)};
  if (is_spent) return all;
  const Mat3 inertia = own.R_WB * spring.of_ball * own.R_WB.transpose();
  all.stiffness = now.rate * now.rate * inertia;
  all.damping = 2.0 * spring.damping_ratio * now.rate * inertia;
  return all;
}

JointSpring SpringDrive::SpringOnHinges(int node, const RegionState& state) const {
  JointSpring all{node, MomentOnHinges(node, state).eigen()};
  const auto& axes = state.kinematics.motion()[node].axis;
  ForEachHinge(node, state, [&](const AtHinge& at) {
    if (SideOfSpent(at.pull) != 0) return;
    const int hinge = state.layout.node(node).first_hinge + at.free;  // no hinge is locked
    const double rate = Now(hinge, state).rate;
    const Vec3 axis = axes[static_cast<size_t>(at.free)].eigen();
    const Mat3 about = at.spring.inertia * axis * axis.transpose();
    all.stiffness += rate * rate * about;
    all.damping += 2.0 * at.spring.damping_ratio * rate * about;
  });
  return all;
}

void SpringDrive::ListSprings(const RegionState& state, std::vector<JointSpring>* springs) const {
  for (int i = 0; i < static_cast<int>(state.layout.nodes().size()); ++i) {
    if (!Pulls(i, state)) continue;
    const bool is_ball = state.model.nodes[i].is_ball;
    springs->push_back(is_ball ? SpringOnBall(i, state) : SpringOnHinges(i, state));
  }
}

Vec3 SpringDrive::Limit(const RegionState& state, int node, const Vec3& moment) const {
  const int first = state.layout.node(node).first_hinge;
  if (state.model.nodes[node].is_ball) {
    const Mat3 R_WB = PullOnBall(node, state).R_WB;
    return R_WB * Limited(springs_[first], Now(first, state), R_WB.transpose() * moment);
  }
  const NodeMotion& own = state.kinematics.motion()[node];
  double torques[3] = {};
  ForEachHinge(node, state, [&](const AtHinge& at) {
    const double torque = moment.dot(own.axis[static_cast<size_t>(at.free)].eigen());
    torques[at.free] = std::clamp(torque, at.pull.least, at.pull.most);
  });
  return MomentOfHinges(own, state.layout.node(node).num_dofs, torques).eigen();
}

bool SpringDrive::has_kinks() const {
  return std::any_of(springs_.begin(), springs_.end(), [](const Spring& spring) {
    return spring.rate > 0.0 && (spring.is_limited() || spring.muscles);
  });
}

// Zeros where the muscles do not give all they can.
void SpringDrive::AppendStrengthKinks(const AtHinge& at, std::vector<double>* kinks) {
  const int side = SideOfSpent(at.pull);
  const JointStrength& muscles = *at.spring.muscles;
  const double rate = side * at.now.rate;
  const StrengthCurve& curve = side > 0 ? muscles.positive : muscles.negative;
  kinks->push_back(rate);
  kinks->push_back(side != 0 ? ShareAboveLeast(curve, at.now.angle, rate) : 0.0);
}

void SpringDrive::AppendKinks(const RegionState& state, std::vector<double>* kinks) const {
  for (int i = 0; i < static_cast<int>(state.layout.nodes().size()); ++i) {
    if (!Pulls(i, state)) continue;
    if (!state.model.nodes[i].is_ball) {
      ForEachHinge(i, state, [&](const AtHinge& at) {
        kinks->push_back(at.pull.pull - at.pull.most);
        kinks->push_back(at.pull.pull - at.pull.least);
        if (at.spring.muscles && at.spring.lists_strength_kinks) AppendStrengthKinks(at, kinks);
      });
      continue;
    }
    const int first = state.layout.node(i).first_hinge;
    if (!springs_[first].is_limited()) continue;
    const Vec3 pull = PullOnBall(i, state).moment;
    kinks->push_back(ExcessOf(springs_[first], Now(first, state), pull) - 1.0);
  }
}

void SpringDrive::ListSpent(const RegionState& state, std::vector<SpentDrive>* spent) const {
  // Of its strength: who gives it less does not mean it to get there.
  constexpr double kAll = 1.0 - 1e-9, kMeansIt = 0.5;
  const auto add = [&](const SpentDrive& own) {
    const bool is_spent = own.torque < kAll * own.wanted;
    if (is_spent && Now(own.hinge, state).share >= kMeansIt) spent->push_back(own);
  };
  for (int i = 0; i < static_cast<int>(state.layout.nodes().size()); ++i) {
    if (!Pulls(i, state)) continue;
    const int first = state.layout.node(i).first_hinge;
    if (!state.model.nodes[i].is_ball) {
      ForEachHinge(i, state, [&](const AtHinge& at) {
        const double given = std::clamp(at.pull.pull, at.pull.least, at.pull.most);
        const double approach = at.off.angle > 0.0 ? -at.off.rate : at.off.rate;
        add({false, first + at.free, std::abs(given), std::abs(at.pull.pull),
             std::abs(at.off.angle), approach});
      });
      continue;
    }
    const BallPull own = PullOnBall(i, state);
    const Vec3 given = Limited(springs_[first], Now(first, state), own.moment);
    const Eigen::AngleAxisd turn(own.E);
    add({true, first, given.norm(), own.moment.norm(), turn.angle(), -turn.axis().dot(own.w)});
  }
}

}  // namespace hazumi
