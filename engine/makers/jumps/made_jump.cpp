// A jump from where the figure stands onto a spot, as ordinary keys: crouch, take-off, apex,
// landing, and back to how it stood; in a stride it brings its feet together first, and stands up
// straight in the end. The feet are pinned until take-off and after the landing; the
// flight between is gravity's (jump_plan.cpp).

#include <algorithm>
#include <cmath>
#include <string_view>

#include "engine/makers/jumps/jump_plan.h"
#include "engine/makers/keyed_moves.h"
#include "engine/project/edits/curves.h"
#include "engine/project/edits/entries.h"
#include "engine/project/edits/keys.h"
#include "engine/project/edits/placements.h"
#include "engine/spatial/degrees.h"

namespace hazumi::makers {

namespace {

constexpr double kCrouchSeconds = 0.4, kRiseSeconds = 0.6;

Stance StanceOf(JumpPhase phase, double stretch, const Stance& start, const JumpBody& body) {
  Stance stance = start;
  for (const NamedJumpHinge& of : body.hinges) {
    const auto& angles = of.hinge.angles;
    const std::string_view name = of.hinge.name;
    const bool is_of_foot = name == "ankle_flexion" || name == "toe";
    const double angle = phase == kStretched && is_of_foot
                             ? angles[kTakeOff] + stretch * (angles[phase] - angles[kTakeOff])
                             : angles[phase];
    stance.q[of.joint.value()] = angle * kDegree;
  }
  stance.angles[1] = kJumpLean[phase];
  return stance;
}

// Upright, with legs that are not turned aside and hang straight down.
Stance Gathered(Stance stance, const JumpBody& body) {
  stance.angles[1] = stance.angles[2] = 0.0;
  for (const JointIndex hinge : body.aside) stance.q[hinge.value()] = 0.0;
  for (const NamedJumpHinge& of : body.hinges) {
    if (of.hinge.bears) stance.q[of.joint.value()] = 0.0;
  }
  return stance;
}

// Returns the middle of the toes in the crouch if one foot stays where it is.
Vec3 SpotOver(const Vec3& foot, size_t side, const Stance& crouch, Stage* stage) {
  const Vec3 middle = stage->ToesOf(crouch, Vec3::Zero());
  const Vec3 aside = middle - stage->FeetOf(crouch, Vec3::Zero())[side];
  return foot + Vec3(aside.x(), aside.y(), 0.0);
}

Result<JumpPlan> PlanJump(const Animation& animation, const MotionFrame& now, const Vec3& target,
                          const JumpTry& how, const JumpBody& body, const ProjectRoot& root) {
  Stage stage(animation, body);
  JumpPlan plan;
  plan.start = now.frame;
  const auto values = RootValues(now.X_WR, root, now.frame);
  plan.before = {now.q, Vec3(values[kRootAngleZ], values[kRootAngleY], values[kRootAngleX])};
  plan.root_before = now.X_WR.p;
  const bool stands = StandsOnBothFeet(plan.before, &stage);
  plan.after = stands ? plan.before : Gathered(plan.before, body);
  for (int phase = 0; phase < kNumJumpPhases; ++phase) {
    plan.stances[phase] = StanceOf(static_cast<JumpPhase>(phase), how.stretch, plan.after, body);
  }
  JumpSpots spots = {stage.ToesOf(plan.before, now.X_WR.p), target};
  if (!stands) {
    const auto feet = stage.FeetOf(plan.before, now.X_WR.p);
    plan.foot = feet[0].z() <= feet[1].z() ? 0 : 1;
    spots.from = SpotOver(feet[plan.foot], plan.foot, plan.stances[kCrouch], &stage);
  }
  const JumpLengths lengths = {FramesOf(kCrouchSeconds, 2, animation),
                               FramesOf(kRiseSeconds, 3, animation)};
  const Result<Done> planned =
      PlanContacts(animation, spots, how.height, lengths, how.push, &stage, &plan);
  if (!planned.ok()) return planned.error();
  return plan;
}

void KeyHinge(const JumpPlan& plan, int hinge, bool bears, ProjectCurve* curve) {
  const auto angle = [&](const Stance& stance) { return stance.q[hinge] / kDegree; };
  RemoveKeysIn(plan.start, plan.end, curve);
  KeyMove(plan.start, angle(plan.before), 0.0, curve);
  for (int phase = 0; phase < kNumJumpPhases; ++phase) {
    std::optional<double> rate;
    if (phase == kCrouch || (phase == kAbsorbed && bears)) rate = 0.0;
    if (plan.rates[phase]) rate = angle(*plan.rates[phase]);
    KeyMove(plan.frames[phase], angle(plan.stances[phase]), rate, curve);
  }
  KeyMove(plan.end, angle(plan.after), 0.0, curve);
}

void KeyRootAngle(const JumpPlan& plan, int angle, ProjectCurve* curve) {
  RemoveKeysIn(plan.start, plan.end, curve);
  KeyMove(plan.start, plan.before.angles[angle], 0.0, curve);
  for (int phase = 0; phase < kNumJumpPhases; ++phase) {
    std::optional<double> rate;
    if (phase == kCrouch || phase == kAbsorbed) rate = 0.0;
    if (plan.rates[phase]) rate = plan.rates[phase]->angles[angle];
    KeyMove(plan.frames[phase], plan.stances[phase].angles[angle], rate, curve);
  }
  KeyMove(plan.end, plan.after.angles[angle], 0.0, curve);
}

// Nothing else may move what the jump moves.
std::optional<Error> CheckFree(const JumpPlan& plan, const Project& project) {
  for (const ProjectPlacement& span : project.placements) {
    const bool is_in_way = span.first_frame < plan.end && span.last_frame > plan.start;
    if (span.kind == PlacementKind::kKeyed || !is_in_way) continue;
    return Refusal("", "frames " + std::to_string(span.first_frame) + " to " +
                           std::to_string(span.last_frame) +
                           " are placed by a pin or by gravity already; jump after them");
  }
  return CheckFreeOfRegions(plan.start, plan.end, "jump before or after it", project);
}

Result<Done> KeyJump(const JumpPlan& plan, const JumpBody& body, const Figure& figure,
                     Project* project) {
  if (const auto error = CheckFree(plan, *project)) return *error;
  const auto key = [&](JointIndex hinge, bool bears) -> Result<Done> {
    const Result<ProjectCurve*> curve = CurveNamed(figure.joint(hinge).name, figure, project);
    if (!curve.ok()) return curve.error();
    KeyHinge(plan, hinge.value(), bears, curve.value());
    return Done();
  };
  for (const NamedJumpHinge& of : body.hinges) {
    if (Result<Done> keyed = key(of.joint, of.hinge.bears); !keyed.ok()) return keyed;
  }
  for (const JointIndex hinge : body.aside) {
    if (plan.before.q[hinge.value()] == plan.after.q[hinge.value()]) continue;
    if (Result<Done> keyed = key(hinge, false); !keyed.ok()) return keyed;
  }
  for (int i = 0; i < 3; ++i) KeyRootAngle(plan, i, &project->root.curves[kRootAngleZ + i]);
  JumpPins pins;
  pins.before.kind = pins.after.kind = PlacementKind::kPinned;
  pins.before.pin = body.feet[plan.foot];
  pins.after.pin = body.feet[0];
  return PutJump(plan, std::move(pins), project);
}

}  // namespace

Result<MadeJump> JumpAsLow(std::optional<double> height, const std::vector<double>& stretches,
                           const JumpSo& jump, const Project& project) {
  constexpr double kLeast = 0.15, kMost = 1.5, kStep = 0.05;  // [m]
  const double most = height.value_or(kMost);
  Error error;
  for (const Push push : {Push::kOfPeople, Push::kAny}) {
    if (height && push == Push::kAny) break;
    for (double tried = height.value_or(kLeast); tried <= most; tried += kStep) {
      for (const double stretch : stretches) {
        MadeJump made = {project, {}};
        const Result<JumpReport> report = jump({tried, stretch, push}, &made.project);
        if (report.ok()) {
          made.report = report.value();
          return made;
        }
        if (push == Push::kOfPeople) error = report.error();
        const bool touches = report.error().place == "first" || report.error().place == "last";
        if (!touches) break;
      }
    }
  }
  return error;
}

Result<MadeJump> MakeJump(const JumpTarget& target, const MotionFrame& now,
                          const Animation& animation, const Project& project) {
  const Figure& figure = *animation.figure;
  const JumpBody body(figure);
  if (const auto error = body.Check(figure)) return *error;
  const Vec3 ahead = now.X_WR.p + now.X_WR.R * Vec3(0.8, 0.0, 0.0);
  const Vec3 spot(target.x.value_or(ahead.x()), target.y.value_or(ahead.y()), 0.0);
  const auto jump = [&](const JumpTry& how, Project* tried) -> Result<JumpReport> {
    const Result<JumpPlan> plan = PlanJump(animation, now, spot, how, body, project.root);
    if (!plan.ok()) return plan.error();
    const Result<Done> keyed = KeyJump(plan.value(), body, figure, tried);
    if (!keyed.ok()) return keyed.error();
    return ReportOf(plan.value(), how.height);
  };
  return JumpAsLow(target.height, {1.0, 0.5, 0.0}, jump, project);
}

}  // namespace hazumi::makers
