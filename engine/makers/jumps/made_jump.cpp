// A jump from where the figure stands onto a spot, as ordinary keys: crouch, take-off, apex,
// landing, and back to how it stood. The feet are pinned until take-off and after the landing; the
// flight between is gravity's (jump_plan.cpp).

#include <algorithm>
#include <cmath>

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

Stance StanceOf(JumpPhase phase, const Stance& start, const JumpBody& body) {
  Stance stance = start;
  for (const NamedJumpHinge& of : body.hinges) {
    stance.q[of.joint.value()] = of.hinge.angles[phase] * kDegree;
  }
  stance.angles[1] = kJumpLean[phase];
  return stance;
}

Result<JumpPlan> PlanJump(const Animation& animation, const MotionFrame& now, const Vec3& target,
                          double height, const JumpBody& body, const ProjectRoot& root) {
  Stage stage(animation, body);
  JumpPlan plan;
  plan.start = now.frame;
  const auto values = RootValues(now.X_WR, root, now.frame);
  plan.before = {now.q, Vec3(values[kRootAngleZ], values[kRootAngleY], values[kRootAngleX])};
  plan.after = plan.before;
  plan.root_before = now.X_WR.p;
  for (int phase = 0; phase < kNumJumpPhases; ++phase) {
    plan.stances[phase] = StanceOf(static_cast<JumpPhase>(phase), plan.before, body);
  }
  const JumpSpots spots = {stage.ToesOf(plan.before, now.X_WR.p), target};
  const JumpLengths lengths = {FramesOf(kCrouchSeconds, 2, animation),
                               FramesOf(kRiseSeconds, 3, animation)};
  const Result<Done> planned = PlanContacts(animation, spots, height, lengths, &stage, &plan);
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
  for (const NamedJumpHinge& of : body.hinges) {
    const Result<ProjectCurve*> curve = CurveNamed(of.name, figure, project);
    if (!curve.ok()) return curve.error();
    KeyHinge(plan, of.joint.value(), of.hinge.bears, curve.value());
  }
  for (int i = 0; i < 3; ++i) KeyRootAngle(plan, i, &project->root.curves[kRootAngleZ + i]);
  JumpPins pins;
  pins.before.kind = pins.after.kind = PlacementKind::kPinned;
  pins.before.pin = pins.after.pin = body.feet[0];
  return PutJump(plan, std::move(pins), project);
}

}  // namespace

Result<MadeJump> JumpAsLow(std::optional<double> height, const JumpSoHigh& jump,
                           const Project& project) {
  constexpr double kLeast = 0.15, kMost = 1.5, kStep = 0.05;  // [m]
  const double most = height.value_or(kMost);
  Error error;
  for (double tried = height.value_or(kLeast); tried <= most; tried += kStep) {
    MadeJump made = {project, {}};
    const Result<JumpReport> report = jump(tried, &made.project);
    if (!report.ok()) {
      error = report.error();
      if (height) break;
      continue;
    }
    made.report = report.value();
    return made;
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
  const auto jump = [&](double height, Project* tried) -> Result<JumpReport> {
    const Result<JumpPlan> plan = PlanJump(animation, now, spot, height, body, project.root);
    if (!plan.ok()) return plan.error();
    const Result<Done> keyed = KeyJump(plan.value(), body, figure, tried);
    if (!keyed.ok()) return keyed.error();
    return ReportOf(plan.value(), height);
  };
  return JumpAsLow(target.height, jump, project);
}

}  // namespace hazumi::makers
