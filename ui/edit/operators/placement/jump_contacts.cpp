// As the feet leave the ground the CoM goes as fast as the flight begins, and as they touch it as
// fast as the flight ends; in between the ground pushes. With the flight's duration T and the CoM's
// place c at both ends the flight has
//   v0 = (c1 - c0) / T - g T / 2,   v1 = v0 + g T.
// From rest in the crouch the CoM gets to v0 on a parabola of time in the stretch S = 2 h / v0z,
// for which it rises by h, and goes v0 S / 2 meanwhile. So the body leans at take-off as far as it
// needs to for the CoM to be there. Landing is that backwards: the CoM is v1 A / 2 behind where it
// comes to rest in A, so that the legs reach forward. The rates of the angles on the frame itself
// are
//   q' = a d + b l,
// with d from the one pose to the other and l the lean about the toes, the foot staying on the
// ground; a and b are such that the CoM has the velocity v in the plane of the figure's forward
// direction and the vertical. What bears nothing, as the arms, goes as its poses before and after
// have it, and counts in v. As the feet touch, the body sinks a little slower than it came down, so
// that they press on the ground instead of grazing it.

#include "ui/edit/operators/placement/jump_contacts.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "ui/edit/operators/edits.h"
#include "ui/edit/operators/placement/root_curves.h"

namespace hazumi::edit {

namespace {

// The feet leave the ground, or touch it.
struct Contact {
  JumpPhase phase, rest;  // rest: in the crouch before it, or in the lowest pose after it
  double sign;            // 1: rest is before it, -1: after it
  const char* foot;       // the hinge that keeps the foot on the ground while the body leans
  double least, most;     // lean, besides kJumpLean [degrees]
};

constexpr Contact kContacts[] = {{kTakeOff, kCrouch, 1.0, "toe", -15.0, 16.0},
                                 {kLanding, kAbsorbed, -1.0, "ankle_flexion", -30.0, 5.0}};

bool Bears(const std::string& name) {
  for (const auto& [hinge_name, hinge] : HingesOfJump()) {
    if (hinge_name == name) return hinge->bears;
  }
  return false;
}

void LeanBy(double degrees, const Contact& contact, const Figure& figure, Stance* stance) {
  stance->angles[1] += degrees;
  for (const char* side : {"r_", "l_"}) {
    stance->q[figure.FindJoint(side + std::string(contact.foot))->value()] += degrees * kDegree;
  }
}

Vec3 Forward(const JumpPlan& plan) {
  const double yaw = plan.before.angles[0] * kDegree;
  return {std::cos(yaw), std::sin(yaw), 0.0};
}

// Of the CoM as the flight begins, or ends.
Vec3 FlightVelocity(const Contact& contact, const Animation& animation, const JumpPlan& plan,
                    Stage* stage) {
  const auto com = [&](JumpPhase phase) {
    return stage->ComOf(plan.stances[phase], plan.roots[phase]);
  };
  const double T = animation.rate.SecondsAt(plan.frames[kLanding] - plan.frames[kTakeOff]);
  const Vec3 half = Vec3(0.0, 0.0, 0.5 * animation.gravity * T);
  return (com(kLanding) - com(kTakeOff)) / T + contact.sign * half;
}

// The lean with which the CoM is where it has to be, by how much it moves for a degree.
void Lean(const Contact& contact, const Animation& animation, Stage* stage, JumpPlan* plan) {
  const Figure& figure = *animation.figure;
  const Vec3 forward = Forward(*plan);
  const Vec3 velocity = FlightVelocity(contact, animation, *plan, stage);
  Stance& stance = plan->stances[contact.phase];
  const Vec3 toes = stage->ToesOf(stance, plan->roots[contact.phase]);
  const Vec3 rest = stage->ComOf(plan->stances[contact.rest], plan->roots[contact.rest]);
  const double seconds =
      animation.rate.SecondsAt(std::abs(plan->frames[contact.phase] - plan->frames[contact.rest]));
  const double wanted = forward.dot(rest) + contact.sign * 0.5 * seconds * forward.dot(velocity);
  Stance leaning = stance;
  LeanBy(1.0, contact, figure, &leaning);
  const double is = forward.dot(stage->ComOver(toes, stance));
  const double by_degree = forward.dot(stage->ComOver(toes, leaning)) - is;
  const double before = stance.angles[1] - kJumpLean[contact.phase];
  const double lean = std::clamp(before + (wanted - is) / by_degree, contact.least, contact.most);
  LeanBy(lean - before, contact, figure, &stance);
}

// By angle, of a pose on the way between those before and after it [rad/s].
VecX RatesBetween(JumpPhase phase, const Animation& animation, const JumpPlan& plan) {
  const double seconds = animation.rate.SecondsAt(plan.frames[phase + 1] - plan.frames[phase - 1]);
  return (plan.stances[phase + 1].q - plan.stances[phase - 1].q) / seconds;
}

// Of all angles as the feet leave the ground, or touch it.
Stance RatesAt(const Contact& contact, const Animation& animation, const JumpPlan& plan,
               Stage* stage) {
  constexpr double kStep = 1e-4;  // [s]
  constexpr double kPress = 0.2;  // [m/s]
  constexpr double kMost = 2.9;   // a cubic that goes 3 times as fast as its chord overshoots
  const Figure& figure = *animation.figure;
  const Stance &stance = plan.stances[contact.phase], &rest = plan.stances[contact.rest];
  const Vec3 toes = stage->ToesOf(stance, plan.roots[contact.phase]);
  const Vec3 forward = Forward(plan), com = stage->ComOver(toes, stance);
  Stance others{RatesBetween(contact.phase, animation, plan), Vec3::Zero()};
  Stance along{contact.sign * (stance.q - rest.q), contact.sign * (stance.angles - rest.angles)};
  for (int i = 0; i < figure.num_joints(); ++i) {
    (Bears(figure.joint(JointIndex(i)).name) ? others : along).q[i] = 0.0;
  }
  Stance lean{VecX::Zero(stance.q.size()), Vec3::Zero()};
  LeanBy(1.0, contact, figure, &lean);
  // Forward and up, per second.
  const auto moves = [&](const Stance& rates) -> Eigen::Vector2d {
    const Vec3 by = stage->ComOver(toes, Going(stance, kStep, rates)) - com;
    return Eigen::Vector2d(forward.dot(by), by.z()) / kStep;
  };
  Vec3 velocity = FlightVelocity(contact, animation, plan, stage);
  if (contact.phase == kLanding) velocity.z() += kPress;
  const Eigen::Vector2d v = Eigen::Vector2d(forward.dot(velocity), velocity.z()) - moves(others);
  Eigen::Matrix2d A;
  A << moves(along), moves(lean);
  Eigen::Vector2d x = A.partialPivLu().solve(v);
  const double seconds =
      animation.rate.SecondsAt(std::abs(plan.frames[contact.phase] - plan.frames[contact.rest]));
  const double most = kMost / seconds;
  if (!(x[0] >= 0.0 && x[0] <= most)) {
    x[0] = std::clamp(v[1] / A(1, 0), 0.0, most);
    x[1] = (v[0] - A(0, 0) * x[0]) / A(0, 1);
  }
  return Going(Going(others, x[0], along), x[1], lean);
}

}  // namespace

Result<Done> PlanContacts(const Animation& animation, const JumpSpots& spots, double height,
                          const JumpLengths& lengths, Stage* stage, JumpPlan* plan) {
  constexpr int kRounds = 5;
  for (int round = 0;; ++round) {
    Result<Done> done = SetRoots(spots, stage, plan);
    if (!done.ok()) return done;
    done = SetTimes(animation, height, lengths, stage, plan);
    if (!done.ok()) return done;
    if (round == kRounds) break;
    for (const Contact& contact : kContacts) Lean(contact, animation, stage, plan);
  }
  for (const Contact& contact : kContacts) {
    plan->rates[contact.phase] = RatesAt(contact, animation, *plan, stage);
  }
  return Done();
}

bool HasContacts(const JumpFrames& frames, const Project& project) {
  const auto says = [&](const std::string& name, JumpPhase phase) {
    const ProjectCurve* curve = FindCurve(name, project);
    const ProjectKey* key = curve ? KeyOn(frames[phase], *curve) : nullptr;
    return key && key->rate;
  };
  return std::all_of(std::begin(kContacts), std::end(kContacts), [&](const Contact& contact) {
    const auto bearing = HingesOfJump();
    return says(kRootCurveNames[kRootAngleY], contact.phase) &&
           std::all_of(bearing.begin(), bearing.end(), [&](const auto& of) {
             return !of.second->bears || says(of.first, contact.phase);
           });
  });
}

void KeyContacts(const JumpPlan& plan, const Figure& figure, Project* project) {
  for (const Contact& contact : kContacts) {
    const int frame = plan.frames[contact.phase];
    const Stance &stance = plan.stances[contact.phase], &rates = *plan.rates[contact.phase];
    for (const auto& [name, hinge] : HingesOfJump()) {
      const Result<ProjectCurve*> curve = CurveNamed(name, figure, project);
      ProjectKey* key = curve.ok() ? KeyOn(frame, curve.value()) : nullptr;
      if (!key || !key->rate) continue;
      const int i = figure.FindJoint(name)->value();
      if (name.ends_with(contact.foot)) key->value = WithoutRoundOff(stance.q[i] / kDegree);
      key->rate = WithoutRoundOff(rates.q[i] / kDegree);
    }
    ProjectKey* key = KeyOn(frame, &project->root.curves[kRootAngleY]);
    if (!key || !key->rate) continue;
    key->value = WithoutRoundOff(stance.angles[1]);
    key->rate = WithoutRoundOff(rates.angles[1]);
  }
}

}  // namespace hazumi::edit
