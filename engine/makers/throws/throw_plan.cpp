// An arm of length L, swung at w, gives the speed L w; swung by an angle a from where it hangs
// down, the direction that rises at a. It swings to the region's start in t at a constant
// acceleration, over the angle w t / 2. What w and a are comes from the throw's path
// (throw_path.cpp), as if it began at the shoulder; ThrowTo finds it exactly.

#include "engine/makers/throws/throw_plan.h"

#include <algorithm>
#include <cmath>

#include "engine/dynamics/kinematics.h"
#include "engine/makers/keyed_moves.h"
#include "engine/makers/throws/throw_path.h"
#include "engine/project/edits/entries.h"

namespace hazumi::makers {

namespace {

constexpr double kBackSeconds = 0.5, kForwardSeconds = 0.15, kFreeSeconds = 0.42,
                 kHomeSeconds = 0.8;
constexpr double kLeastSwing = 60.0 * kDegree, kMostSwing = 900.0 * kDegree;  // [rad/s]

// The hand of an arm; a forearm without one ends in it.
std::optional<GroupIndex> HandOf(const FigureBody& body, BodySide side) {
  const std::optional<GroupIndex> hand = body.Find(BodyRole::kHand, side);
  return hand ? hand : body.Find(BodyRole::kForearm, side);
}

// " (r_wrist or l_wrist)", as the figure's hands are called.
std::string HandsOf(const Figure& figure) {
  const FigureBody body(figure);
  std::string hands;
  for (const BodySide side : {BodySide::kRight, BodySide::kLeft}) {
    const std::optional<GroupIndex> hand = HandOf(body, side);
    if (hand) hands += (hands.empty() ? " (" : " or ") + figure.group(*hand).name;
  }
  return hands.empty() ? hands : hands + ")";
}

Result<HolderSpan> ThrowerOf(const ProjectHeldObject& object, int frame,
                             const ProjectFrames& frames, const Figure& figure) {
  const std::vector<HolderSpan> spans = HoldersOf(object, frames);
  const HolderSpan* holder = HolderAt(frame, spans);
  if (!holder) {
    return Refusal("object",
                   "nobody has \"" + object.name + "\" in frame " + std::to_string(frame) +
                       ": select a wrist and pass it on, or go to a frame in which a hand "
                       "has it");
  }
  if (SideOfHand(holder->joint, figure)) return *holder;
  return Refusal("object", "\"" + holder->joint + "\" has \"" + object.name +
                               "\" in this frame: a throw is made of what a hand has" +
                               HandsOf(figure));
}

bool MovesLegs(const ThrowPlan& plan, const Project& project) {
  for (const ProjectPlacement& span : project.placements) {
    if (span.first_frame < plan.end && span.last_frame > plan.start) return false;
  }
  for (const ProjectCurve& curve : project.root.curves) {
    for (const ProjectKey& key : curve.keys) {
      if (key.frame > plan.start && key.frame <= plan.end) return false;
    }
  }
  return std::none_of(project.holds.begin(), project.holds.end(), [&](const ProjectHold& hold) {
    return hold.first_frame < plan.end && hold.last_frame > plan.start;
  });
}

void SetTimes(const Animation& animation, ThrowPlan* plan) {
  plan->back = plan->start + FramesOf(kBackSeconds, 3, animation);
  plan->region_first = plan->back + FramesOf(kForwardSeconds, 2, animation);
  plan->forward = animation.rate.SecondsAt(plan->region_first - plan->back);
  plan->region_last = plan->region_first + FramesOf(kFreeSeconds, 4, animation);
  plan->end = plan->region_last + FramesOf(kHomeSeconds, 4, animation);
}

}  // namespace

std::vector<NamedThrowHinge> HingesOfThrow(BodySide side, const Figure& figure) {
  const std::string own = side == BodySide::kRight ? "r_" : "l_";
  const std::string other = side == BodySide::kRight ? "l_" : "r_";
  const FigureBody body(figure);
  std::vector<NamedThrowHinge> all;
  for (const ThrowHinge& hinge : kThrowHinges) {
    std::vector<std::string> sides = {own};
    if (hinge.limb == ThrowLimb::kTrunk) sides = {""};
    if (hinge.limb == ThrowLimb::kOtherArm) sides = {other};
    if (hinge.limb == ThrowLimb::kLegs) sides = {own, other};
    for (const std::string& of : sides) {
      for (const HingeShare& share : body.HingesFor(of + hinge.name)) {
        AddShare(share, hinge, figure, &all);
      }
    }
  }
  return all;
}

std::optional<BodySide> SideOfHand(const std::string& holder, const Figure& figure) {
  const std::optional<GroupIndex> joint = figure.FindGroup(holder);
  const FigureBody body(figure);
  for (const BodySide side : {BodySide::kRight, BodySide::kLeft}) {
    const std::optional<GroupIndex> end = HandOf(body, side);
    const bool is_of_hand =
        joint && end && figure.IsBeyond(figure.group(*joint).first, figure.group(*end).first);
    if (is_of_hand &&
        body.HingeFor((side == BodySide::kRight ? "r_" : "l_") + std::string("shoulder_flexion"))) {
      return side;
    }
  }
  return std::nullopt;
}

double BearingOf(const Vec3& spot, const Vec3& from, const Pose& X_WR) {
  const Vec3 ahead = X_WR.R * Vec3::UnitX(), away = spot - from;
  return std::remainder(std::atan2(away.y(), away.x()) - std::atan2(ahead.y(), ahead.x()),
                        2.0 * EIGEN_PI);
}

Vec3 ShoulderIn(const MotionFrame& frame, GroupIndex shoulder, const Figure& figure) {
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, frame.X_WR, frame.q, &ws);
  return ws.body(figure.group(shoulder).first).p;
}

ThrowSwing SwingFor(const ThrowTarget& target, const Vec3& shoulder, double arm, double gravity) {
  const Vec3& spot = target.spot;
  const double high =
      std::max({0.0, spot.z() - shoulder.z(),
                target.height.value_or(HeightOfSlowestThrow(shoulder, spot, gravity))});
  const Vec3 velocity = ThrowOver(shoulder, spot, high, gravity).velocity;
  const double speed =
      arm > 0.0 ? std::clamp(velocity.norm() / arm, kLeastSwing, kMostSwing) : kLeastSwing;
  return {speed, std::atan2(velocity.z(), velocity.head<2>().norm())};
}

double SwungBy(const ThrowSwing& swing, double forward) { return 0.5 * swing.speed * forward; }

int LikelyRelease(const ThrowSwing& swing, double back, double forward, const ProjectRegion& region,
                  const Animation& animation) {
  const double from = back + SwungBy(swing, forward);
  const int frames = FramesOf((swing.rise - from) / swing.speed, 1, animation);
  return std::min(region.first_frame + frames, region.last_frame);
}

Result<ThrowPlan> PlanThrow(const Animation& animation, const MotionFrame& now,
                            const ThrowTarget& target, const Project& project) {
  const Vec3& spot = target.spot;
  const Figure& figure = *animation.figure;
  if (const auto error = CheckBody({"r_shoulder_flexion"}, "throw", figure)) return *error;
  ThrowPlan plan;
  plan.start = now.frame;
  const Result<HolderSpan> holder =
      ThrowerOf(project.held_objects[target.object], now.frame, project.frames, figure);
  if (!holder.ok()) return holder.error();
  plan.holder = holder.value();
  plan.side = *SideOfHand(plan.holder.joint, figure);
  const FigureBody body(figure);
  plan.shoulder = *body.Find(BodyRole::kUpperArm, plan.side);
  plan.pin = StandingJoint(body, plan.side, figure);
  const Vec3 shoulder = ShoulderIn(now, plan.shoulder, figure);
  plan.bearing = BearingOf(spot, shoulder, now.X_WR);
  if (std::abs(plan.bearing) > kWidestThrow) {
    return Refusal("x",
                   "the spot is " + std::to_string(std::lround(std::abs(plan.bearing) / kDegree)) +
                       " degrees to the side of where the figure faces; turn the figure to it");
  }
  const double arm = (now.objects[target.object].X_WO.p - shoulder).norm();
  if (!(animation.gravity > 0.0)) return Refusal("object", "without gravity nothing comes down");
  plan.swing = SwingFor(target, shoulder, arm, animation.gravity);
  SetTimes(animation, &plan);
  plan.moves_legs = !plan.pin.empty() && MovesLegs(plan, project);
  return plan;
}

}  // namespace hazumi::makers
