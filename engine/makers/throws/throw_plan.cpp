#include "engine/makers/throws/throw_plan.h"

#include <algorithm>
#include <cmath>

#include "engine/analysis/object_landing.h"
#include "engine/dynamics/kinematics.h"
#include "engine/makers/keyed_moves.h"
#include "engine/makers/throws/throw_path.h"
#include "engine/project/edits/entries.h"
#include "engine/spatial/degrees.h"

namespace hazumi::makers {

namespace {

constexpr double kBackSeconds = 0.5, kAfterSeconds = 0.3, kHomeSeconds = 0.9;
constexpr double kForwardSeconds[kNumThrowStyles] = {0.38, 0.36, 0.36};

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

Result<HolderSpan> ThrowerNow(const ProjectHeldObject& object, int frame,
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
  plan->wind_up = plan->start;
  if (!plan->is_drawn_back) plan->wind_up += FramesOf(kBackSeconds, 3, animation);
  plan->release = plan->wind_up + ForwardFrames(plan->shape.style, animation);
  plan->region_last = plan->release + FramesOf(kAfterSeconds, 2, animation);
  plan->end = plan->region_last + HomeFrames(animation);
}

}  // namespace

int ForwardFrames(ThrowStyle style, const Animation& animation) {
  return FramesOf(kForwardSeconds[static_cast<size_t>(style)], 4, animation);
}

int HomeFrames(const Animation& animation) { return FramesOf(kHomeSeconds, 4, animation); }

// The trunk leads.
int ThrowPlan::swung() const { return release - std::max(1, (release - wind_up) / 6); }

Vec3 CentreOn(const Vec3& spot, int object, const Animation& animation) {
  return spot + InnerRadius(animation.held_objects[static_cast<size_t>(object)]) * Vec3::UnitZ();
}

int ThrowPlan::passes() const { return (region_last + end) / 2; }

namespace {

Vec3 ShoulderIn(const MotionFrame& frame, BodySide side, const Figure& figure) {
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, frame.X_WR, frame.q, &ws);
  const GroupIndex arm = *FigureBody(figure).Find(BodyRole::kUpperArm, side);
  return ws.body(figure.group(arm).first).p;
}

}  // namespace

ThrowShape ShapeOf(BodySide side, ThrowStyle style, const Vec3& spot, const MotionFrame& standing,
                   const Animation& animation) {
  constexpr double kWholeSpeed = 7.0;  // of a throw whose poses are whole [m/s]
  constexpr double kLeastSize = 0.45;
  const Vec3 shoulder = ShoulderIn(standing, side, *animation.figure);
  const double g = animation.gravity;
  const double high =
      std::max({0.0, spot.z() - shoulder.z(), HeightOfSlowestThrow(shoulder, spot, g)});
  const double speed = ThrowOver(shoulder, spot, high, g).velocity.norm();
  ThrowShape shape;
  shape.side = side;
  shape.style = style;
  shape.bearing = std::clamp(BearingOf(spot, shoulder, standing.X_WR), -kWidestThrow, kWidestThrow);
  shape.size = std::clamp(speed / kWholeSpeed, kLeastSize, 1.0);
  return shape;
}

double AngleIn(ThrowPhase phase, const NamedThrowHinge& of, const ThrowShape& shape,
               const Figure& figure) {
  const ThrowAngles& angles = of.hinge.At(shape.style);
  double angle = angles[kRelease] + shape.size * (angles[phase] - angles[kRelease]);
  if (of.hinge.is_mirrored && shape.side == BodySide::kLeft) angle = -angle;
  // The trunk is turned to the spot as far as its hinges go.
  angle += of.hinge.turns * shape.bearing / kDegree;
  const Joint& joint = figure.joint(of.joint);
  return std::clamp(angle, joint.lower / kDegree, joint.upper / kDegree);
}

std::optional<ThrowStyle> StyleDrawnBack(BodySide side, const MotionFrame& frame,
                                         const Figure& figure) {
  constexpr double kInFront = 0.25;  // of the shoulder [m of a shoulder 1.4 m high]
  constexpr double kShoulderHeight = 1.4;
  const FigureBody body(figure);
  const std::optional<GroupIndex> hand = HandOf(body, side);
  const std::optional<GroupIndex> arm = body.Find(BodyRole::kUpperArm, side);
  if (!hand || !arm) return std::nullopt;
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, frame.X_WR, frame.q, &ws);
  const Vec3 shoulder = ws.body(figure.group(*arm).first).p;
  const Vec3 reach = ws.body(figure.group(*hand).last()).p - shoulder;
  const double size = shoulder.z() / kShoulderHeight;
  if ((frame.X_WR.R * Vec3::UnitX()).dot(reach) > kInFront * size) return std::nullopt;
  const VecX& q = frame.q;
  double hanging = 0.0;  // sums of squares [deg^2]
  std::array<double, kNumThrowStyles> off = {};
  for (const NamedThrowHinge& of : HingesOfThrow(side, figure)) {
    const std::string_view name = of.hinge.name;
    const bool tells = name.starts_with("shoulder") || name == "elbow_flexion";
    if (of.hinge.limb != ThrowLimb::kThrowingArm || !tells) continue;
    const double angle = q[of.joint.value()] / kDegree;
    hanging += angle * angle;
    for (size_t s = 0; s < off.size(); ++s) {
      const double there = angle - of.hinge.angles[s][kWindUp];
      off[s] += there * there;
    }
  }
  const auto nearest = std::min_element(off.begin(), off.end());
  if (*nearest >= hanging) return std::nullopt;
  return static_cast<ThrowStyle>(nearest - off.begin());
}

double BearingOf(const Vec3& spot, const Vec3& from, const Pose& X_WR) {
  const Vec3 ahead = X_WR.R * Vec3::UnitX(), away = spot - from;
  return std::remainder(std::atan2(away.y(), away.x()) - std::atan2(ahead.y(), ahead.x()),
                        2.0 * EIGEN_PI);
}

Result<ThrowPlan> PlanThrow(const Animation& animation, const MotionFrame& now,
                            const ThrowTarget& target, const Project& project) {
  const Vec3& spot = target.spot;
  const Figure& figure = *animation.figure;
  if (const auto error = CheckBody({"r_shoulder_flexion"}, "throw", figure)) return *error;
  ThrowPlan plan;
  plan.start = now.frame;
  const Result<HolderSpan> holder = ThrowerNow(
      project.held_objects[static_cast<size_t>(target.object)], now.frame, project.frames, figure);
  if (!holder.ok()) return holder.error();
  plan.holder = holder.value();
  const BodySide side = *SideOfHand(plan.holder.joint, figure);
  const FigureBody body(figure);
  plan.shoulder = *body.Find(BodyRole::kUpperArm, side);
  plan.pin = StandingJoint(body, side, figure);
  const double bearing = BearingOf(spot, ShoulderIn(now, side, figure), now.X_WR);
  if (std::abs(bearing) > kWidestThrow) {
    return Refusal("x", "the spot is " + std::to_string(std::lround(std::abs(bearing) / kDegree)) +
                            " degrees to the side of where the figure faces; turn the figure to "
                            "it");
  }
  if (!(animation.gravity > 0.0)) return Refusal("object", "without gravity nothing comes down");
  const std::optional<ThrowStyle> drawn = StyleDrawnBack(side, now, figure);
  plan.is_drawn_back = drawn && (!target.style || target.style == drawn);
  const ThrowStyle style = target.style.value_or(drawn.value_or(ThrowStyle::kUnderarm));
  plan.shape = ShapeOf(side, style, CentreOn(spot, target.object, animation), now, animation);
  SetTimes(animation, &plan);
  plan.moves_legs = !plan.pin.empty() && MovesLegs(plan, project);
  return plan;
}

}  // namespace hazumi::makers
