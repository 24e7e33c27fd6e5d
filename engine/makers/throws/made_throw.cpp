// A throw of what a hand holds, from how the figure stands onto a spot: the arm is drawn back and
// throws by keys (solved_throw.cpp); once it has let go a dynamics region moves it on, and keys
// bring it back to how it was, or to rest. Trunk, legs and the other arm go along, the trunk turns
// to the spot.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/makers/keyed_moves.h"
#include "engine/makers/throws/solved_throw.h"
#include "engine/makers/throws/throw_plan.h"
#include "engine/makers/throws/throws.h"
#include "engine/project/edits/curves.h"
#include "engine/project/edits/entries.h"
#include "engine/project/edits/keys.h"
#include "engine/project/edits/placements.h"
#include "engine/spatial/degrees.h"

namespace hazumi::makers {

namespace {

bool StandsAllTheTime(const Project& project) {
  const auto is_still = [](const ProjectCurve& curve) {
    return std::all_of(curve.keys.begin(), curve.keys.end(), [&](const ProjectKey& key) {
      return key.value == curve.keys.front().value && key.rate.value_or(0.0) == 0.0;
    });
  };
  return project.placements.empty() && project.holds.empty() &&
         std::all_of(project.root.curves.begin(), project.root.curves.end(), is_still);
}

// A figure that only stands is turned to a spot that is beside or behind it, in all frames.
void TurnTo(const Vec3& spot, MotionFrame* now, Project* project) {
  constexpr double kBeside = 35.0 * kDegree;
  const double turn = BearingOf(spot, now->X_WR.p, now->X_WR);
  if (std::abs(turn) < kBeside || !StandsAllTheTime(*project)) return;
  const double degrees = std::round(turn / kDegree);
  ProjectCurve& curve = project->root.curves[kRootAngleZ];
  if (curve.keys.empty()) KeyMove(project->frames.first, 0.0, {}, &curve);
  for (ProjectKey& key : curve.keys) key.value = WithoutRoundOff(key.value + degrees);
  const Mat3 R = Eigen::AngleAxisd(degrees * kDegree, Vec3::UnitZ()).toRotationMatrix();
  now->X_WR.R = R * now->X_WR.R;
  for (ObjectPose& object : now->objects) {
    if (!object.is_held()) continue;
    object.X_WO = {R * object.X_WO.R, now->X_WR.p + R * (object.X_WO.p - now->X_WR.p)};
  }
}

// A foot stays flat while hip, knee and ankle together keep it so: their rates are the same sum of
// their angles, which rates that follow from each curve by itself are not.
void KeyLeg(const ThrowPlan& plan, const std::array<double, kNumThrowPhases>& angles, double home,
            double frame_time, ProjectCurve* curve) {
  constexpr double kGoesOn = 0.65;  // how much of its speed it has as the region ends
  const auto rate = [&](double from, double to, int frames) {
    return (to - from) / (frames * frame_time);
  };
  const double arrives =
      rate(angles[kRelease], angles[kFollowThrough], plan.region_last - plan.swung());
  const double leaves = rate(angles[kFollowThrough], home, plan.end - plan.region_last);
  KeyMove(plan.swung(), angles[kRelease],
          rate(angles[kWindUp], angles[kFollowThrough], plan.region_last - plan.wind_up), curve);
  KeyMove(plan.region_last, angles[kFollowThrough], kGoesOn * arrives + (1.0 - kGoesOn) * leaves,
          curve);
}

// `standing`: the angle from which the throw begins [degrees].
void KeyHinge(const ThrowPlan& plan, const NamedThrowHinge& of, double standing, double frame_time,
              const Figure& figure, ProjectCurve* curve) {
  std::array<double, kNumThrowPhases> angles = {};
  for (const ThrowPhase phase : {kWindUp, kRelease, kFollowThrough}) {
    angles[phase] = AngleIn(phase, of, plan.shape, figure);
  }
  if (plan.is_drawn_back) angles[kWindUp] = standing;
  const double home = plan.is_drawn_back ? figure.joint(of.joint).rest / kDegree : standing;
  RemoveKeysIn(plan.start + 1, plan.end, curve);
  if (!plan.is_drawn_back || !KeyOn(plan.start, *curve)) {
    KeyMove(plan.start, standing, 0.0, curve);
  }
  if (!plan.is_drawn_back) KeyMove(plan.wind_up, angles[kWindUp], 0.0, curve);
  if (of.hinge.limb == ThrowLimb::kLegs) {
    KeyLeg(plan, angles, home, frame_time, curve);
  } else if (of.hinge.limb == ThrowLimb::kThrowingArm) {
    KeyMove(plan.passes(), angles[kFollowThrough], {}, curve);
  } else {
    KeyMove(plan.swung(), angles[kRelease], {}, curve);
    KeyMove(plan.region_last, angles[kFollowThrough], {}, curve);
  }
  KeyMove(plan.end, home, 0.0, curve);
}

ProjectRegion RegionOf(const ThrowPlan& plan, const Figure& figure, const Project& project) {
  ProjectRegion region;
  region.name = FreeName("throw", project.regions);
  region.first_frame = plan.release;
  region.last_frame = plan.region_last;
  region.joints = {{figure.group(plan.shoulder).name, true, {}}};
  region.friction.default_factor = kThrowFriction;
  const std::optional<GroupIndex> hand = HandOf(FigureBody(figure), plan.shape.side);
  if (hand) region.friction.joints.push_back({figure.group(*hand).name, kHandFriction});
  region.contacts.self = project.solver.method == Method::kExact;
  region.limit_tangents = true;
  return region;
}

Result<Done> KeyThrow(const ThrowPlan& plan, const MotionFrame& now, const Animation& animation,
                      Project* project) {
  const Figure& figure = *animation.figure;
  if (const auto error =
          CheckFreeOfRegions(plan.start, plan.end, "throw before or after it", *project)) {
    return *error;
  }
  project->frames.last = std::max(project->frames.last, plan.end);
  for (const NamedThrowHinge& of : HingesOfThrow(plan.shape.side, figure)) {
    if (of.hinge.limb == ThrowLimb::kLegs && !plan.moves_legs) continue;
    const Result<ProjectCurve*> curve = CurveNamed(of.name, figure, project);
    if (!curve.ok()) return curve.error();
    const double standing = ShortestDegrees(now.q[of.joint.value()]);
    KeyHinge(plan, of, standing, animation.rate.seconds_per_frame(), figure, curve.value());
  }
  project->regions.push_back(RegionOf(plan, figure, *project));
  if (!plan.moves_legs) return Done();
  ProjectPlacement pin;
  pin.kind = PlacementKind::kPinned;
  pin.pin = plan.pin;
  pin.first_frame = plan.start;
  pin.last_frame = plan.end;
  return PutPlacement(pin, true, &project->placements);
}

}  // namespace

Result<MadeThrow> MakeThrow(const ThrowTarget& target, const MotionFrame& now,
                            const Animation& animation, const Project& project) {
  Project made = project;
  MotionFrame standing = now;
  TurnTo(target.spot, &standing, &made);
  const Result<ThrowPlan> plan = PlanThrow(animation, standing, target, made);
  if (!plan.ok()) return plan.error();
  const Result<Done> keyed = KeyThrow(plan.value(), standing, animation, &made);
  if (!keyed.ok()) return keyed.error();
  ThrowTarget onto = target;
  onto.style = plan.value().shape.style;
  const SolvedSpan span = {plan.value().holder.number, made.regions.size() - 1,
                           plan.value().wind_up, plan.value().release, plan.value().release};
  return SolveThrow(onto, span, animation, std::move(made));
}

}  // namespace hazumi::makers
