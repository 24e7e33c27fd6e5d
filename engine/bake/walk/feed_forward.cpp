// T = Dinv(q, q', q'' + C q', a) [Arai (1)], C the friction rates of the joints that regions move:
// then the accelerations x that the equations of motion give are q'' + C q', and friction makes
// q'' of them [METHOD 2.2]. The root moves as x has it: as it is told, so that a pin p is still, or
// so that the centre of mass falls freely. The wrench that is left on the root is dropped, but for
// a pin's force f, which relieves the hinges between root and pin of their part,
//   T_i -= axis_i . ((p - p_i) x f).

#include "engine/bake/walk/feed_forward.h"

#include <algorithm>
#include <cmath>

#include "engine/dynamics/inverse_dynamics.h"

namespace hazumi {

FeedForward::FeedForward(const Animation& animation, const Figure& figure,
                         const std::vector<int>& active)
    : figure_(figure),
      gravity_(animation.gravity),
      friction_(VecX::Zero(figure.num_joints())),
      ws_(figure) {
  for (const int r : active) {
    const DynamicsRegion& region = animation.regions[r];
    for (size_t i = 0; i < region.joints.size(); ++i) {
      if (region.friction[i] == 0.0) continue;  // it keeps its angle
      friction_[region.joints[i].value()] = -30.0 * std::log(region.friction[i]);
    }
    for (const Drive& drive : region.drives) {
      for (const JointIndex j : drive.joints) {
        const GroupIndex group = figure.joint(j).group;
        const auto axes = BallAxesOf(figure, figure.group(group));
        if (drive.feed_forward && axes) balls_.emplace(group, *axes);
      }
    }
  }
}

ForwardTorques FeedForward::Of(FigureMotion motion, const RootHold& hold) {
  motion.qdd += friction_.cwiseProduct(motion.qd);
  RootMotion& root = motion.root;
  JointIndex pin;
  if (hold.coupling == RootCoupling::kPinned) {
    pin = hold.pin;
    PinRoot(figure_, pin, Vec3::Zero(), &ws_, &motion);
  }
  ComputePositions(figure_, motion.X_WR, motion.q, &ws_);
  root.a.z() += gravity_;
  if (hold.coupling == RootCoupling::kFlight) {
    root.a.setZero();
    ComputeMotion(figure_, root, motion.qd, motion.qdd, &ws_);
    root.a = -CenterOfMassAcceleration(figure_, ws_);
  }
  InverseDynamics(figure_, root, motion.qd, motion.qdd, nullptr, &ws_);
  ForwardTorques forward{ws_.tau, VecX::Zero(figure_.num_joints())};
  if (pin.is_valid()) HangOnPin(pin, &forward);
  AddMoments(pin, &forward);
  return forward;
}

void FeedForward::HangOnPin(JointIndex pin, ForwardTorques* forward) {
  const Vec3 force = ws_.bodies[0].f;
  for (int i = 0; i < figure_.num_joints(); ++i) {
    forward->torques[i] -= OriginJacobian(figure_, ws_, pin, JointIndex(i)).dot(force);
  }
}

void FeedForward::AddMoments(JointIndex pin, ForwardTorques* forward) {
  for (const auto& [index, ball] : balls_) {
    const JointGroup& group = figure_.group(index);
    const BodyScratch& last = ws_.body(group.last());
    Vec3 moment = last.n;
    if (pin.is_valid() && figure_.IsBeyond(pin, group.last())) {
      moment -= (ws_.body(pin).p - last.p).cross(ws_.bodies[0].f);
    }
    forward->moments.segment<3>(group.first.value()) = (last.R * ball.R_JB).transpose() * moment;
  }
}

}  // namespace hazumi
