// A throw that is there is aimed at another spot: by the goal of a made throw, whose keys follow,
// or by a region of the animator.

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/dynamics/kinematics.h"
#include "engine/makers/keyed_moves.h"
#include "engine/makers/throws/solved_throw.h"
#include "engine/makers/throws/throw_plan.h"
#include "engine/project/edits/curves.h"
#include "engine/project/edits/entries.h"
#include "engine/project/edits/goals.h"
#include "engine/project/edits/keys.h"

namespace hazumi::makers {

namespace {

// A throw: what is thrown, by whom, and the region that moves the arm.
struct ThrowCase {
  HolderSpan holder;
  size_t region = 0;  // of Animation::regions
  // Goal of a throw that was solved before, of Project::goals.
  std::optional<size_t> goal;
};

// The next time that it is let go; if there is none the last time.
Result<HolderSpan> ReleaseOf(const ProjectHeldObject& object, const ProjectFrames& frames,
                             double now) {
  std::optional<HolderSpan> found;
  for (const HolderSpan& span : HoldersOf(object, frames)) {
    if (!span.is_let_go) continue;
    found = span;
    if (span.last >= now) break;
  }
  if (found) return *found;
  return Refusal("object", "nobody lets go of \"" + object.name + "\": let go of it first");
}

// Number of hinges from a joint to the root that a region moves.
int MovedBy(const DynamicsRegion& region, GroupIndex joint, const Figure& figure) {
  int count = 0;
  for (JointIndex j = figure.group(joint).last(); j.is_valid(); j = figure.joint(j).parent) {
    if (std::binary_search(region.joints.begin(), region.joints.end(), j)) ++count;
  }
  return count;
}

Result<ThrowCase> CaseOf(int object, double frame, const Animation& animation,
                         const Project& project) {
  const ProjectHeldObject& thrown = project.held_objects[static_cast<size_t>(object)];
  const Result<HolderSpan> release = ReleaseOf(thrown, project.frames, frame);
  if (!release.ok()) return release.error();
  ThrowCase of;
  of.holder = release.value();
  const int last = of.holder.last;
  const auto joint = animation.figure->FindGroup(of.holder.joint);
  int most = 0;
  for (size_t i = 0; joint && i < animation.regions.size(); ++i) {
    const DynamicsRegion& region = animation.regions[i];
    if (last < region.first_frame || last > region.last_frame) continue;
    const int count = MovedBy(region, *joint, *animation.figure);
    if (count <= most) continue;
    most = count;
    of.region = i;
  }
  if (most == 0) {
    return Refusal("object", "no dynamics region moves " + of.holder.joint + " in frame " +
                                 std::to_string(last) +
                                 ", in which it lets go: mark one that begins before that");
  }
  for (size_t i = 0; i < project.goals.size(); ++i) {
    const ProjectGoal& goal = project.goals[i];
    const bool is_it = goal.kind == GoalKind::kObject && goal.object == thrown.name;
    if (is_it && goal.frame == last) of.goal = i;
  }
  return of;
}

// A key of a made throw, and the phase whose angle it has.
struct ThrowKey {
  ProjectKey* key;
  const NamedThrowHinge* hinge;
  ThrowPhase phase;
};

std::vector<ThrowKey> KeysOf(const ThrowPlan& plan, const std::vector<NamedThrowHinge>& hinges,
                             const Figure& figure, Project* project) {
  const std::pair<int, ThrowPhase> phases[] = {
      {plan.wind_up, kWindUp}, {plan.swung(), kRelease}, {plan.region_last, kFollowThrough}};
  std::vector<ThrowKey> keys;
  for (const NamedThrowHinge& of : hinges) {
    const Result<ProjectCurve*> curve = CurveNamed(of.name, figure, project);
    if (!curve.ok()) continue;
    for (const auto& [frame, phase] : phases) {
      ProjectKey* const key = KeyOn(frame, curve.value());
      if (key) keys.push_back({key, &of, phase});
    }
  }
  return keys;
}

// Frame in which the arm of a solved throw begins to swing: that of its last key before it lets go
// which the solver did not write.
int WindUpOf(int release, const DynamicsRegion& region, GroupIndex holder, const Figure& figure,
             const Project& project) {
  std::optional<int> found;
  for (JointIndex j = figure.group(holder).last(); j.is_valid(); j = figure.joint(j).parent) {
    if (!std::binary_search(region.joints.begin(), region.joints.end(), j)) continue;
    const ProjectCurve* const curve = FindCurve(figure.joint(j).name, project);
    if (!curve) continue;
    for (const ProjectKey& key : curve->keys) {
      const bool is_swing = key.type == KeyType::kBreakdown;
      const int frame = static_cast<int>(key.frame);
      if (frame < release && !is_swing) found = std::max(found.value_or(frame), frame);
    }
  }
  return found.value_or(release - 1);
}

// Frame in which a figure stood as a throw was made: that of the key before the wind-up.
int StartOf(int wind_up, const std::vector<NamedThrowHinge>& hinges, const Project& project) {
  int start = wind_up;
  for (const NamedThrowHinge& of : hinges) {
    if (of.hinge.limb != ThrowLimb::kThrowingArm) continue;
    const ProjectCurve* const curve = FindCurve(of.name, project);
    if (!curve || !KeyOn(wind_up, *curve)) continue;
    for (const ProjectKey& key : curve->keys) {
      if (key.frame < wind_up) start = static_cast<int>(key.frame);
    }
    break;
  }
  return start;
}

// Keys that stand where MakeThrow put them for the throw of a goal go where it puts them for
// another spot and style.
void Rekey(const ProjectGoal& goal, const ThrowTarget& onto, BodySide side, int wind_up,
           const DynamicsRegion& region, const Animation& animation, const Motion& motion,
           Project* project) {
  constexpr double kSame = 1e-6;  // [degrees]
  const Figure& figure = *animation.figure;
  ThrowPlan plan;
  plan.wind_up = wind_up;
  plan.release = goal.frame;
  plan.region_last = region.last_frame;
  const std::vector<NamedThrowHinge> hinges = HingesOfThrow(side, figure);
  const auto angle = [&](const ThrowKey& of, const ThrowShape& shape) {
    return WithoutRoundOff(AngleIn(of.phase, *of.hinge, shape, figure));
  };
  const int start = StartOf(plan.wind_up, hinges, *project);
  for (const int stood : {start, plan.wind_up}) {  // drawn back already, it stood there
    const MotionFrame& standing = motion.frames[static_cast<size_t>(stood - animation.first_frame)];
    const ThrowShape from = ShapeOf(side, goal.style, goal.position_m, standing, animation);
    const ThrowShape to = ShapeOf(side, *onto.style, CentreOn(onto.spot, onto.object, animation),
                                  standing, animation);
    bool any = false;
    for (const ThrowKey& of : KeysOf(plan, hinges, figure, project)) {
      if (std::abs(of.key->value - angle(of, from)) > kSame) continue;
      of.key->value = angle(of, to);
      any = true;
    }
    if (any) break;
  }
}

// Frame in which an arm is drawn back, and for what.
struct DrawnBack {
  int frame = 0;
  std::optional<ThrowStyle> style;
};

// The last one with a key of the arm up to a region's first frame; if there is none, that first
// frame, from which it swings however it is.
DrawnBack LastDrawnBack(BodySide side, const HolderSpan& holder, const DynamicsRegion& region,
                        const Animation& animation, const Motion& motion) {
  constexpr double kLongest = 1.2;  // before it lets go [s]
  const Figure& figure = *animation.figure;
  std::set<int> frames;
  const GroupIndex joint = *figure.FindGroup(holder.joint);
  for (JointIndex j = figure.group(joint).last(); j.is_valid(); j = figure.joint(j).parent) {
    if (!std::binary_search(region.joints.begin(), region.joints.end(), j)) continue;
    for (const Key& key : animation.joint_keys[static_cast<size_t>(j.value())]) {
      const int frame = static_cast<int>(key.frame);
      const bool is_near = animation.rate.SecondsAt(holder.last - frame) <= kLongest;
      if (is_near && frame <= region.first_frame) frames.insert(frame);
    }
  }
  const auto drawn_back_in = [&](int frame) -> std::optional<ThrowStyle> {
    if (frame < animation.first_frame) return std::nullopt;
    const size_t at = static_cast<size_t>(frame - animation.first_frame);
    return StyleDrawnBack(side, motion.frames[at], figure);
  };
  for (auto frame = frames.rbegin(); frame != frames.rend(); ++frame) {
    if (const auto style = drawn_back_in(*frame)) return {*frame, style};
  }
  return {region.first_frame, drawn_back_in(region.first_frame)};
}

// Frame in which an arm lets go that swings from its wind-up: as given, if there is time.
int ReleaseAfter(int wind_up, const DynamicsRegion& region, int given, ThrowStyle style,
                 const Animation& animation) {
  constexpr double kShortest = 0.15;  // [s]
  if (animation.rate.SecondsAt(given - wind_up) >= kShortest) return given;
  const int planned = wind_up + ForwardFrames(style, animation);
  return std::max(wind_up + 1, std::min(planned, region.last_frame - 1));
}

}  // namespace

bool HasThrow(int object, double frame, const Animation& animation, const Project& project) {
  const std::vector<HolderSpan> spans =
      HoldersOf(project.held_objects[static_cast<size_t>(object)], project.frames);
  const HolderSpan* holder = HolderAt(static_cast<int>(frame), spans);
  const bool keeps_it = holder && !holder->is_let_go;
  return !keeps_it && CaseOf(object, frame, animation, project).ok();
}

Result<MadeThrow> AimThrow(const ThrowTarget& target, double frame, const Animation& animation,
                           const Motion& motion, const Project& project) {
  const Result<ThrowCase> found = CaseOf(target.object, frame, animation, project);
  if (!found.ok()) return found.error();
  const ThrowCase& of = found.value();
  const DynamicsRegion& region = animation.regions[of.region];
  const Figure& figure = *animation.figure;
  Project made = project;
  ThrowTarget onto = target;
  const std::optional<BodySide> side = SideOfHand(of.holder.joint, figure);
  SolvedSpan span = {of.holder.number, of.region, region.first_frame, of.holder.last};
  if (of.goal) {
    const ProjectGoal& goal = project.goals[*of.goal];
    if (!onto.style) onto.style = goal.style;
    const GroupIndex holder = *figure.FindGroup(of.holder.joint);
    span.wind_up = WindUpOf(goal.frame, region, holder, figure, project);
    if (side) Rekey(goal, onto, *side, span.wind_up, region, animation, motion, &made);
    return SolveThrow(onto, span, animation, std::move(made));
  }
  if (side) {
    const DrawnBack drawn = LastDrawnBack(*side, of.holder, region, animation, motion);
    span.wind_up = drawn.frame;
    if (!onto.style) onto.style = drawn.style;
  }
  if (!onto.style) onto.style = ThrowStyle::kUnderarm;
  span.release = ReleaseAfter(span.wind_up, region, of.holder.last, *onto.style, animation);
  return SolveThrow(onto, span, animation, std::move(made));
}

}  // namespace hazumi::makers
