// T = Dinv(q, q', q'' + C q', a) [Arai (1)], C the friction rates of the joints that regions move:
// then the accelerations x that the equations of motion give are q'' + C q', and friction makes
// q'' of them [METHOD 2.2]. The root moves as x has it: as it is told, so that a pin p is still, or
// so that the centre of mass falls freely. The wrench that is left on the root is dropped, but for
// a pin's force f, which relieves the hinges between root and pin of their part,
//   T_i -= axis_i . ((p - p_i) x f).
// A figure that stands is pinned at the joint that carries most, and the points p where it touches
// the scene supply the wrench on the root, by forces f that relieve the hinges likewise
// [METHOD 2.6].

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
      friction_[region.joints[i].value()] = FrictionRate(region.friction[i]);
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
  const bool flies = hold.coupling == RootCoupling::kFlight;
  const bool stands = flies && !support_.empty();
  RootMotion& root = motion.root;
  JointIndex pin;
  if (hold.coupling == RootCoupling::kPinned) {
    pin = hold.pin;
    PinRoot(figure_, pin, Vec3::Zero(), &ws_, &motion);
  } else if (stands) {
    PinRoot(figure_, stance_, Vec3::Zero(), &ws_, &motion);
  }
  ComputePositions(figure_, motion.X_WR, motion.q, &ws_);
  root.a.z() += gravity_;
  if (flies && !stands) {
    root.a.setZero();
    ComputeMotion(figure_, root, motion.qd, motion.qdd, &ws_);
    root.a = -CenterOfMassAcceleration(figure_, ws_);
  }
  InverseDynamics(figure_, root, motion.qd, motion.qdd, nullptr, &ws_);
  ForwardTorques forward{ws_.tau, VecX::Zero(figure_.num_joints())};
  if (pin.is_valid()) HangOnPin(pin, &forward);
  AddMoments(pin, &forward);
  if (stands) StandOnSupport(&forward);
  return forward;
}

void FeedForward::StandAsIn(const FigureMotion& motion, const std::vector<SceneObject>& scene) {
  ComputePositions(figure_, motion.X_WR, motion.q, &ws_);
  support_ = FindSupport(figure_, scene, ws_);
  const auto by_root = [](const SupportPoint& point) { return !point.joint.is_valid(); };
  std::erase_if(support_, by_root);  // support of the root's own body moves no joint
  if (support_.empty()) return;
  const Wrench lift = {Vec3::UnitZ(), Vec3::Zero()};
  const std::vector<Vec3> forces = SupportForces(support_, lift, CenterOfMass(figure_, ws_), ws_);
  std::map<int, double> loads;  // share of the weight, by joint
  for (size_t i = 0; i < support_.size(); ++i) loads[support_[i].joint.value()] += forces[i].z();
  const auto is_less = [](const auto& a, const auto& b) { return a.second < b.second; };
  stance_ = JointIndex(std::max_element(loads.begin(), loads.end(), is_less)->first);
}

void FeedForward::StandOnSupport(ForwardTorques* forward) {
  const BodyScratch& root = ws_.bodies[0];
  const std::vector<Vec3> forces = SupportForces(support_, {root.f, root.n}, root.p, ws_);
  for (size_t k = 0; k < support_.size(); ++k) {
    const Vec3 p = support_[k].Place(ws_);
    for (int i = 0; i < figure_.num_joints(); ++i) {
      if (!IsMovedBy(figure_, support_[k], JointIndex(i))) continue;
      const BodyScratch& hinge = ws_.body(JointIndex(i));
      forward->torques[i] -= hinge.axis.dot((p - hinge.p).cross(forces[k]));
    }
    for (const auto& [index, ball] : balls_) {
      const JointGroup& group = figure_.group(index);
      if (!IsMovedBy(figure_, support_[k], group.last())) continue;
      const BodyScratch& last = ws_.body(group.last());
      const Mat3 R_BW = (last.R * ball.R_JB).transpose();
      forward->moments.segment<3>(group.first.value()) -= R_BW * (p - last.p).cross(forces[k]);
    }
  }
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
