// As the feet leave the ground the CoM goes as fast as the flight begins, and as they touch it as
// fast as the flight ends; in between the ground pushes. With the flight's duration T and the CoM's
// place c at both ends the flight has
//   v0 = (c1 - c0) / T - g T / 2,   v1 = v0 + g T.
// From rest in the crouch the CoM gets to it in the stretch S = 2 h / v0z, for which it rises by h,
// and goes k0 v0 S meanwhile; from the landing to rest in A it goes k1 v1 A. A cubic of time does
// that without turning round if k is from 1/3 to 2/3; with k = 1/2 it speeds up evenly, with less
// it is braked most at first. On level ground, with the CoM as far ahead of the toes as r0 and r1
// at rest, and toes that are put D ahead,
//   D + r1 - r0 = v (T + k0 S + k1 A),
// which gives the speed v of the flight, and that how far the CoM has to be ahead of the toes at
// take-off and landing, to where the body leans. Where it cannot lean so far k is another one, and
// a jump for which the CoM would turn round, or be pushed too hard, is refused.
//
// The rates of the angles on the frame itself are
//   q' = a d + b l,
// with d from the one pose to the other and l the lean, the foot staying on the ground; a and b are
// such that the CoM has the velocity v in the plane of the figure's forward direction and the
// vertical. What bears nothing, as the arms, goes as its poses before and after have it, and counts
// in v. As the feet touch, the body sinks a little slower than it came down, so that they press on
// the ground instead of grazing it.

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "engine/base/text.h"
#include "engine/makers/jumps/jump_plan.h"
#include "engine/project/edits/curves.h"
#include "engine/project/edits/entries.h"
#include "engine/project/edits/keys.h"
#include "engine/spatial/degrees.h"

namespace hazumi::makers {

namespace {

// The feet leave the ground, or touch it.
struct Contact {
  JumpPhase phase, rest;  // rest: in the crouch before it, or in the lowest pose after it
  double sign;            // 1: rest is before it, -1: after it
  double trunk;           // so much of the lean the trunk takes part in, the legs in all of it
  double least, most;     // lean, besides kJumpLean [degrees]
};

constexpr Contact kContacts[] = {{kTakeOff, kCrouch, 1.0, 1.0, -15.0, 16.0},
                                 {kLanding, kAbsorbed, -1.0, 0.4, -30.0, 5.0}};

// The hinges of the contact's feet; a foot without a toe leans about its ankle.
const std::array<std::optional<JointIndex>, 2>& FeetOf(const Contact& contact,
                                                       const JumpBody& body) {
  return contact.phase == kTakeOff && body.toes[0] ? body.toes : body.ankles;
}

// The legs about the foot, and the trunk on them.
void LeanBy(double degrees, const Contact& contact, const JumpBody& body, Stance* stance) {
  stance->angles[1] += contact.trunk * degrees;
  for (size_t side = 0; side < 2; ++side) {
    const auto turn = [&](const std::optional<JointIndex>& hinge, double by) {
      if (hinge) stance->q[hinge->value()] += by * kDegree;
    };
    turn(FeetOf(contact, body)[side], degrees);
    turn(body.hips[side], (contact.trunk - 1.0) * degrees);
  }
}

double LeanOf(const Contact& contact, const Stance& stance) {
  return (stance.angles[1] - kJumpLean[contact.phase]) / contact.trunk;
}

// Takes away the lean that its foot tells, and has it turned as the poses are. Returns the lean.
double Straighten(const Contact& contact, const JumpBody& body, Stance* stance) {
  const std::optional<JointIndex>& foot = FeetOf(contact, body)[0];
  const NamedJumpHinge* hinge = foot ? body.Find(*foot) : nullptr;
  const double lean = hinge
                          ? stance->q[foot->value()] / kDegree - hinge->hinge.angles[contact.phase]
                          : LeanOf(contact, *stance);
  LeanBy(-lean, contact, body, stance);
  stance->angles[1] = kJumpLean[contact.phase];
  return lean;
}

Vec3 Forward(const JumpPlan& plan) {
  const double yaw = plan.before.angles[0] * kDegree;
  return {std::cos(yaw), std::sin(yaw), 0.0};
}

// Returns the velocity of the CoM as the flight begins, or ends.
Vec3 FlightVelocity(const Contact& contact, const Animation& animation, const JumpPlan& plan,
                    Stage* stage) {
  const auto com = [&](JumpPhase phase) {
    return stage->ComOf(plan.stances[phase], plan.roots[phase]);
  };
  const double T = animation.rate.SecondsAt(plan.frames[kLanding] - plan.frames[kTakeOff]);
  const Vec3 half = Vec3(0.0, 0.0, 0.5 * animation.gravity * T);
  return (com(kLanding) - com(kTakeOff)) / T + contact.sign * half;
}

// Returns how far the CoM is ahead of the toes [m].
double Ahead(JumpPhase phase, const JumpPlan& plan, Stage* stage) {
  return Forward(plan).dot(stage->ComOver(Vec3::Zero(), plan.stances[phase]));
}

// The lean with which the CoM is so far ahead of the toes, or the nearest it can have.
void LeanTo(const Contact& contact, double ahead, Stage* stage, JumpPlan* plan) {
  constexpr int kSteps = 8;
  Stance& stance = plan->stances[contact.phase];
  const auto lean_by = [&](double degrees) { LeanBy(degrees, contact, stage->body(), &stance); };
  for (int i = 0; i < kSteps; ++i) {
    const double is = Ahead(contact.phase, *plan, stage);
    lean_by(1.0);
    const double by_degree = Ahead(contact.phase, *plan, stage) - is;
    lean_by(-1.0);
    const double lean = LeanOf(contact, stance);
    const double wanted = lean + (ahead - is) / by_degree;
    lean_by(std::clamp(wanted, contact.least, contact.most) - lean);
  }
}

// Between a contact and its rest.
double SecondsOf(const Contact& contact, const Animation& animation, const JumpPlan& plan) {
  return animation.rate.SecondsAt(std::abs(plan.frames[contact.phase] - plan.frames[contact.rest]));
}

constexpr double kEvenly = 0.5;  // k of an even push

// The k of a landing at this speed [m/s]: braked evenly if that is hard, else most at first, so
// that the body is soon over the feet.
double LandingShare(double speed, double seconds) {
  constexpr double kHard = 12.0;  // [m/s^2]
  if (speed == 0.0) return kEvenly;
  return std::clamp((4.0 - kHard * seconds / std::abs(speed)) / 6.0, 1.0 / 3.0, kEvenly);
}

// Both leans, each with what the other one cannot do.
void Lean(const Animation& animation, const JumpSpots& spots, Stage* stage, JumpPlan* plan) {
  const auto& [push, catching] = kContacts;
  const auto ahead = [&](JumpPhase phase) { return Ahead(phase, *plan, stage); };
  const double D = Forward(*plan).dot(spots.onto - spots.from);
  const double T = animation.rate.SecondsAt(plan->frames[kLanding] - plan->frames[kTakeOff]);
  const double r0 = ahead(kCrouch), r1 = ahead(kAbsorbed), way = D + r1 - r0;
  const double S = kEvenly * SecondsOf(push, animation, *plan);
  double A = 0.0;
  for (int i = 0; i < 4; ++i) {
    const double seconds = SecondsOf(catching, animation, *plan);
    A = seconds * LandingShare(way / (T + S + A), seconds);
  }
  LeanTo(push, r0 + S * way / (T + S + A), stage, plan);
  LeanTo(catching, r1 - A * (D + r1 - ahead(kTakeOff)) / (T + A), stage, plan);
  LeanTo(push, r0 + S * (D + ahead(kLanding) - r0) / (T + S), stage, plan);
}

// Whether the CoM goes from rest to the flight's speed, and from that to rest, without turning
// round and without a jerk. The cubic's accelerations at its ends are
//   4 v / S - 6 d / S^2,   6 d / S^2 - 2 v / S.
bool GetsUpToSpeed(const Animation& animation, const JumpPlan& plan, Stage* stage) {
  constexpr double kMost = 20.0, kBack = 3.0;  // [m/s^2]
  for (const Contact& contact : kContacts) {
    const double S = SecondsOf(contact, animation, plan);
    const double v = Forward(plan).dot(FlightVelocity(contact, animation, plan, stage));
    const double d =
        contact.sign * (Ahead(contact.phase, plan, stage) - Ahead(contact.rest, plan, stage));
    for (const double end : {4.0 * v / S - 6.0 * d / (S * S), 6.0 * d / (S * S) - 2.0 * v / S}) {
      const double along = v < 0.0 ? -end : end;
      if (along > kMost || along < -kBack) return false;
    }
  }
  return true;
}

// Returns rates of all angles of a pose between those before and after it [rad/s].
VecX RatesBetween(JumpPhase phase, const Animation& animation, const JumpPlan& plan) {
  const double seconds = animation.rate.SecondsAt(plan.frames[phase + 1] - plan.frames[phase - 1]);
  return (plan.stances[phase + 1].q - plan.stances[phase - 1].q) / seconds;
}

// Rates of all angles as the feet leave the ground, or touch it, and by how much the CoM goes
// otherwise than it flies [m/s].
struct ContactRates {
  Stance rates;
  double off = 0.0;
};
ContactRates RatesAt(const Contact& contact, const Animation& animation, const JumpPlan& plan,
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
    const NamedJumpHinge* hinge = stage->body().Find(JointIndex(i));
    (hinge && hinge->hinge.bears ? others : along).q[i] = 0.0;
  }
  Stance lean{VecX::Zero(stance.q.size()), Vec3::Zero()};
  LeanBy(1.0, contact, stage->body(), &lean);
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
  const double most = kMost / SecondsOf(contact, animation, plan);
  if (!(x[0] >= 0.0 && x[0] <= most)) {
    x[0] = std::clamp(v[1] / A(1, 0), 0.0, most);
    x[1] = (v[0] - A(0, 0) * x[0]) / A(0, 1);
  }
  return {Going(Going(others, x[0], along), x[1], lean), (A * x - v).norm()};
}

// Sets the rates at take-off and landing. Errors: kSchema if the body does not move there as it
// flies.
Result<Done> SetRates(const Animation& animation, Push push, Stage* stage, JumpPlan* plan) {
  constexpr double kMostOff = 0.5;
  bool goes_as_it_flies = GetsUpToSpeed(animation, *plan, stage);
  double speed = 0.0;
  for (const Contact& contact : kContacts) {
    const Vec3 velocity = FlightVelocity(contact, animation, *plan, stage);
    speed = Forward(*plan).dot(velocity);
    const bool is_flat = std::abs(speed) > std::abs(velocity.z());
    ContactRates at = RatesAt(contact, animation, *plan, stage);
    if (is_flat && at.off > kMostOff * std::abs(velocity.z())) goes_as_it_flies = false;
    plan->rates[contact.phase] = std::move(at.rates);
  }
  if (goes_as_it_flies || push == Push::kAny) return Done();
  return Refusal("height", "it would fly forward at " + FormatShort(speed) +
                               " m/s, which the legs cannot give or take: give a greater height, "
                               "or a nearer spot");
}

}  // namespace

Result<Done> PlanContacts(const Animation& animation, const JumpSpots& spots, double height,
                          const JumpLengths& lengths, Push push, Stage* stage, JumpPlan* plan) {
  constexpr int kRounds = 5;
  const Contact &leaving = kContacts[0], &catching = kContacts[1];
  const double leant = Straighten(leaving, stage->body(), &plan->stances[kTakeOff]);
  Straighten(catching, stage->body(), &plan->stances[kLanding]);
  Result<Done> done = SetRoots(spots, stage, plan);
  for (int round = 0; round < kRounds && done.ok(); ++round) {
    done = SetTimes(animation, height, lengths, stage, plan);
    if (!done.ok()) break;
    Lean(animation, spots, stage, plan);
    done = SetRoots(spots, stage, plan);
  }
  if (!done.ok()) return done;
  plan->stances[kStretched].angles[1] += LeanOf(leaving, plan->stances[kTakeOff]) - leant;
  return SetRates(animation, push, stage, plan);
}

void KeyContacts(const JumpPlan& plan, const JumpBody& body, const Figure& figure,
                 Project* project) {
  for (const Contact& contact : kContacts) {
    const int frame = plan.frames[contact.phase];
    const Stance &stance = plan.stances[contact.phase], &rates = *plan.rates[contact.phase];
    const auto leans = [&](JointIndex joint) {
      const auto is_it = [&](const std::optional<JointIndex>& other) { return other == joint; };
      const auto& feet = FeetOf(contact, body);
      return std::any_of(feet.begin(), feet.end(), is_it) ||
             std::any_of(body.hips.begin(), body.hips.end(), is_it);
    };
    for (const NamedJumpHinge& of : body.hinges) {
      const Result<ProjectCurve*> curve = CurveNamed(of.name, figure, project);
      ProjectKey* key = curve.ok() ? KeyOn(frame, curve.value()) : nullptr;
      if (!key || !key->rate) continue;
      const int i = of.joint.value();
      if (leans(of.joint)) key->value = WithoutRoundOff(stance.q[i] / kDegree);
      key->rate = WithoutRoundOff(rates.q[i] / kDegree);
    }
    ProjectKey* key = KeyOn(frame, &project->root.curves[kRootAngleY]);
    if (!key || !key->rate) continue;
    key->value = WithoutRoundOff(stance.angles[1]);
    key->rate = WithoutRoundOff(rates.angles[1]);
  }
  ProjectKey* key = KeyOn(plan.frames[kStretched], &project->root.curves[kRootAngleY]);
  if (key) key->value = WithoutRoundOff(plan.stances[kStretched].angles[1]);
}

}  // namespace hazumi::makers
