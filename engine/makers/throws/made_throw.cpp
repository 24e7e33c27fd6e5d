// A throw of what a hand holds, from how the figure stands onto a spot, as ordinary keys and a
// dynamics region: the arm swings back, then forward as fast as the region starts, lets go in it,
// swings on by itself and comes back to how it hung. The trunk turns to the spot and with the arm.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/makers/keyed_moves.h"
#include "engine/makers/throws/throw_plan.h"
#include "engine/makers/throws/throws.h"
#include "engine/project/edits/curves.h"
#include "engine/project/edits/entries.h"
#include "engine/project/edits/keys.h"
#include "engine/project/edits/placements.h"
#include "engine/spatial/degrees.h"

namespace hazumi::makers {

namespace {

// The trunk is turned to the spot as far as its hinges go.
double AngleIn(ThrowPhase phase, const NamedThrowHinge& of, const ThrowPlan& plan,
               const Figure& figure) {
  double angle = of.hinge.angles[phase];
  if (of.hinge.is_mirrored && plan.side == BodySide::kLeft) angle = -angle;
  angle += of.hinge.turns * plan.bearing / kDegree;
  const Joint& joint = figure.joint(of.joint);
  return std::clamp(angle, joint.lower / kDegree, joint.upper / kDegree);
}

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

// Keys a hinge of the shoulder that begins to swing at the angle `back` [degrees].
void KeyStart(int frame, const ThrowHinge& hinge, double back, const ThrowSwing& swing,
              double forward, ProjectCurve* curve) {
  const bool swings = hinge.swings();
  KeyMove(frame, back + (swings ? SwungBy(swing, forward) / kDegree : 0.0),
          swings ? swing.speed / kDegree : 0.0, curve);
}

// A foot stays flat while hip, knee and ankle together keep it so: their rates are the same sum of
// their angles, which rates that follow from each curve by itself are not.
void KeyLeg(const ThrowPlan& plan, const std::array<double, kNumThrowPhases>& angles,
            double standing, ProjectCurve* curve) {
  constexpr double kGoesOn = 0.65;  // how much of its speed it has as the region ends
  const int swing = (plan.region_first + plan.region_last) / 2;
  const double frame_time = plan.forward / (plan.region_first - plan.back);  // [s]
  const auto rate = [&](double from, double to, int frames) {
    return (to - from) / (frames * frame_time);
  };
  const double arrives = rate(angles[kSwing], angles[kFollowThrough], plan.region_last - swing);
  const double leaves = rate(angles[kFollowThrough], standing, plan.end - plan.region_last);
  KeyMove(swing, angles[kSwing],
          rate(angles[kBackswing], angles[kFollowThrough], plan.region_last - plan.back), curve);
  KeyMove(plan.region_last, angles[kFollowThrough], kGoesOn * arrives + (1.0 - kGoesOn) * leaves,
          curve);
}

void KeyHinge(const ThrowPlan& plan, const NamedThrowHinge& of, double standing,
              const Figure& figure, ProjectCurve* curve) {
  const auto angle = [&](ThrowPhase phase) { return AngleIn(phase, of, plan, figure); };
  RemoveKeysIn(plan.start, plan.end, curve);
  KeyMove(plan.start, standing, 0.0, curve);
  KeyMove(plan.back, angle(kBackswing), 0.0, curve);
  if (of.hinge.limb == ThrowLimb::kShoulder) {
    KeyStart(plan.region_first, of.hinge, angle(kBackswing), plan.swing, plan.forward, curve);
  } else if (of.hinge.limb == ThrowLimb::kLegs) {
    KeyLeg(plan, of.hinge.angles, standing, curve);
  } else {
    KeyMove((plan.region_first + plan.region_last) / 2, angle(kSwing), {}, curve);
    KeyMove(plan.region_last, angle(kFollowThrough), {}, curve);
  }
  KeyMove(plan.end, standing, 0.0, curve);
}

ProjectRegion RegionOf(const ThrowPlan& plan, const Figure& figure, const Project& project) {
  ProjectRegion region;
  region.name = FreeName("throw", project.regions);
  region.first_frame = plan.region_first;
  region.last_frame = plan.region_last;
  region.joints = {{figure.group(plan.shoulder).name, false, {}}};
  region.limit_tangents = true;
  return region;
}

Result<Done> KeyThrow(const ThrowPlan& plan, const MotionFrame& now, const Figure& figure,
                      Project* project) {
  if (const auto error =
          CheckFreeOfRegions(plan.start, plan.end, "throw before or after it", *project)) {
    return *error;
  }
  project->frames.last = std::max(project->frames.last, plan.end);
  for (const NamedThrowHinge& of : HingesOfThrow(plan.side, figure)) {
    if (of.hinge.limb == ThrowLimb::kLegs && !plan.moves_legs) continue;
    const Result<ProjectCurve*> curve = CurveNamed(of.name, figure, project);
    if (!curve.ok()) return curve.error();
    const double standing = ShortestDegrees(now.q[of.joint.value()]);
    KeyHinge(plan, of, standing, figure, curve.value());
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

// The keys between which the arm of a made throw goes back and begins to swing forward: it stands
// still on both, and all hinges of the shoulder have one there.
struct Backswing {
  int start = 0, back = 0;
};

std::optional<Backswing> BackswingOf(const ThrowCase& of,
                                     const std::vector<NamedThrowHinge>& hinges,
                                     const Project& project) {
  const int first = project.regions[static_cast<size_t>(of.region)].first_frame;
  std::optional<Backswing> found;
  for (const NamedThrowHinge& hinge : hinges) {
    if (hinge.hinge.limb != ThrowLimb::kShoulder) continue;
    const ProjectCurve* curve = FindCurve(hinge.name, project);
    const ProjectKey* start = curve ? KeyOn(first, *curve) : nullptr;
    const auto n = start ? start - curve->keys.data() : 0;
    if (n < 2 || !start->rate || start->rate_in) return std::nullopt;
    const ProjectKey &back = start[-1], &before = start[-2];
    if (back.rate != 0.0 || before.rate != 0.0) return std::nullopt;
    const Backswing here = {static_cast<int>(before.frame), static_cast<int>(back.frame)};
    if (found && (found->start != here.start || found->back != here.back)) return std::nullopt;
    found = here;
  }
  return found;
}

// The trunk turns so much farther to the left [rad].
void TurnTrunk(double by, int first, int last, const std::vector<NamedThrowHinge>& hinges,
               const Figure& figure, Project* project) {
  for (const NamedThrowHinge& of : hinges) {
    const ThrowHinge& hinge = of.hinge;
    if (hinge.turns == 0.0) continue;
    const Result<ProjectCurve*> curve = CurveNamed(of.name, figure, project);
    if (!curve.ok()) continue;
    for (ProjectKey& key : curve.value()->keys) {
      if (key.frame <= first || key.frame > last) continue;
      key.value = WithoutRoundOff(std::clamp(key.value + hinge.turns * by / kDegree,
                                             figure.joint(of.joint).lower / kDegree,
                                             figure.joint(of.joint).upper / kDegree));
    }
  }
}

}  // namespace

void SwingAnew(const ThrowTarget& target, const Animation& animation, const Motion& motion,
               ThrowCase* of, Project* project) {
  ProjectHeldObject* object = &project->held_objects[static_cast<size_t>(of->object)];
  const std::string& joint =
      of->holder < 0 ? object->joint : object->holders[static_cast<size_t>(of->holder)].joint;
  const Figure& figure = *animation.figure;
  const std::optional<BodySide> side = SideOfHand(joint, figure);
  if (!side) return;
  const GroupIndex arm = *FigureBody(figure).Find(BodyRole::kUpperArm, *side);
  const std::vector<NamedThrowHinge> hinges = HingesOfThrow(*side, figure);
  const auto backswing = BackswingOf(*of, hinges, *project);
  if (!backswing) return;
  const ProjectRegion& region = project->regions[static_cast<size_t>(of->region)];
  const MotionFrame& standing =
      motion.frames[static_cast<size_t>(backswing->start - animation.first_frame)];
  const Vec3 shoulder = ShoulderIn(standing, arm, figure);
  const Vec3& in_hand = standing.objects[static_cast<size_t>(of->object)].X_WO.p;
  const ThrowSwing swing =
      SwingFor(target, shoulder, (in_hand - shoulder).norm(), animation.gravity);
  const double forward = animation.rate.SecondsAt(region.first_frame - backswing->back);
  double arm_back = 0.0;
  for (const NamedThrowHinge& hinge : hinges) {
    if (hinge.hinge.limb != ThrowLimb::kShoulder) continue;
    const Result<ProjectCurve*> curve = CurveNamed(hinge.name, figure, project);
    if (!curve.ok()) return;
    const double back = KeyOn(backswing->back, *curve.value())->value;
    if (hinge.hinge.swings()) arm_back = back * kDegree;
    KeyStart(region.first_frame, hinge.hinge, back, swing, forward, curve.value());
  }
  const auto lay = [&](int axis) { return object->position.curves[axis].keys.back().value; };
  if (!object->position.curves[0].keys.empty()) {
    const Vec3 before(lay(0), lay(1), 0.0);
    const auto bearing = [&](const Vec3& spot) {
      return std::clamp(BearingOf(spot, shoulder, standing.X_WR), -kWidestThrow, kWidestThrow);
    };
    TurnTrunk(bearing(target.spot) - bearing(before), backswing->start, region.last_frame, hinges,
              figure, project);
  }
  of->has_backswing = true;
  of->release = LikelyRelease(swing, arm_back, forward, region, animation);
  EndOf(of->holder, object) = of->release;
}

Result<MadeThrow> MakeThrow(const ThrowTarget& target, const MotionFrame& now,
                            const Animation& animation, const Project& project) {
  MadeThrow made = {project, {}};
  MotionFrame standing = now;
  TurnTo(target.spot, &standing, &made.project);
  const Result<ThrowPlan> plan = PlanThrow(animation, standing, target, made.project);
  if (!plan.ok()) return plan.error();
  const Result<Done> keyed = KeyThrow(plan.value(), standing, *animation.figure, &made.project);
  if (!keyed.ok()) return keyed.error();
  ThrowCase of;
  of.object = target.object;
  of.holder = plan.value().holder.number;
  of.has_backswing = true;
  of.region = static_cast<int>(made.project.regions.size()) - 1;
  of.release = LikelyRelease(plan.value().swing, kShoulderBack * kDegree, plan.value().forward,
                             made.project.regions.back(), animation);
  EndOf(of.holder, &made.project.held_objects[static_cast<size_t>(of.object)]) = of.release;
  const Result<ThrowReport> thrown = ThrowTo(target, of, animation.figure, &made.project);
  if (!thrown.ok()) return thrown.error();
  made.report = thrown.value();
  return made;
}

}  // namespace hazumi::makers
