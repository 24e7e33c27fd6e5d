// A throw that is there is aimed at another spot: by the goal of a made throw, whose keys follow,
// or by a region of the animator.

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "engine/dynamics/kinematics.h"
#include "engine/makers/keyed_moves.h"
#include "engine/makers/throws/solved_throw.h"
#include "engine/makers/throws/throw_plan.h"
#include "engine/project/edits/curves.h"
#include "engine/project/edits/entries.h"
#include "engine/project/edits/goals.h"
#include "engine/project/edits/keys.h"
#include "engine/project/enum_names.h"

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

// Number of frames from a region that moves the arm to a frame; nothing: it is more than a second,
// and the region is of another throw.
std::optional<int> Apart(const DynamicsRegion& region, int frame, const Animation& animation) {
  const int apart = std::max({0, region.first_frame - frame, frame - region.last_frame});
  if (animation.rate.SecondsAt(apart) > 1.0) return std::nullopt;
  return apart;
}

Result<ThrowCase> CaseOf(int object, double frame, const Animation& animation,
                         const Project& project) {
  const ProjectHeldObject& thrown = project.held_objects[static_cast<size_t>(object)];
  const Result<HolderSpan> release = ReleaseOf(thrown, project.frames, frame);
  if (!release.ok()) return release.error();
  ThrowCase of;
  of.holder = release.value();
  const int last = of.holder.last;
  for (size_t i = 0; i < project.goals.size(); ++i) {
    const ProjectGoal& goal = project.goals[i];
    const bool is_throw = goal.kind == GoalKind::kObject && goal.object == thrown.name;
    if (is_throw && goal.frame == last) of.goal = i;
  }
  const auto joint = animation.figure->FindGroup(of.holder.joint);
  int nearest = std::numeric_limits<int>::max(), most = 0;
  for (size_t i = 0; joint && i < animation.regions.size(); ++i) {
    const DynamicsRegion& region = animation.regions[i];
    const std::optional<int> apart = Apart(region, last, animation);
    const int count = MovedBy(region, *joint, *animation.figure);
    // The region of a throw whose release was moved goes with it.
    if (count == 0 || !apart || (*apart > 0 && !of.goal)) continue;
    if (*apart > nearest || (*apart == nearest && count <= most)) continue;
    nearest = *apart;
    most = count;
    of.region = i;
  }
  if (most > 0) return of;
  return Refusal("object", "no dynamics region moves " + of.holder.joint + " in frame " +
                               std::to_string(last) +
                               ", in which it lets go: mark one that begins there or before");
}

// A key of a made throw, and the phase whose angle it has.
struct ThrowKey {
  ProjectKey* key;
  const NamedThrowHinge* hinge;
  ThrowPhase phase;
};

std::vector<ThrowKey> KeysOf(const ThrowPlan& plan, const std::vector<NamedThrowHinge>& hinges,
                             const Figure& figure, Project* project) {
  std::vector<ThrowKey> keys;
  for (const NamedThrowHinge& of : hinges) {
    const Result<ProjectCurve*> curve = CurveNamed(of.name, figure, project);
    if (!curve.ok()) continue;
    const bool throws = of.hinge.limb == ThrowLimb::kThrowingArm;
    const auto add = [&](int frame, ThrowPhase phase) {
      if (ProjectKey* const key = KeyOn(frame, curve.value())) keys.push_back({key, &of, phase});
    };
    add(plan.wind_up, kWindUp);
    if (!throws) add(plan.swung(), kRelease);
    add(throws ? plan.passes() : plan.region_last, kFollowThrough);
  }
  return keys;
}

// Whether a key is one of a swing that was found.
bool IsOfSwing(const ProjectKey& key) {
  return key.type == KeyType::kBreakdown && key.rate && !key.rate_in;
}

// Frame in which the arm of a solved throw begins to swing: that of the key before its swing, which
// ends with the region's first frame. Nothing: there is no swing that was found.
std::optional<int> WindUpOf(const DynamicsRegion& region, GroupIndex holder,
                            const Animation& animation, const Project& project) {
  const Figure& figure = *animation.figure;
  std::optional<int> found;
  for (JointIndex j = figure.group(holder).last(); j.is_valid(); j = figure.joint(j).parent) {
    if (!std::binary_search(region.joints.begin(), region.joints.end(), j)) continue;
    const ProjectCurve* const curve = FindCurve(figure.joint(j).name, project);
    const ProjectKey* key = curve ? KeyOn(region.first_frame, *curve) : nullptr;
    if (!key || !IsOfSwing(*key)) continue;
    while (key != curve->keys.data() && IsOfSwing(*key)) --key;
    const int frame = std::max(static_cast<int>(key->frame), animation.first_frame);
    found = std::min(found.value_or(frame), frame);
  }
  return found;
}

// Frame in which a figure stood as a throw was made: that of the key before the wind-up.
int StartOf(int wind_up, const std::vector<NamedThrowHinge>& hinges, const Project& project) {
  int start = wind_up;
  for (const NamedThrowHinge& of : hinges) {
    if (of.hinge.limb != ThrowLimb::kThrowingArm) continue;
    const ProjectCurve* const curve = FindCurve(of.name, project);
    if (!curve || !KeyOn(wind_up, *curve)) continue;
    for (const ProjectKey& key : curve->keys) {
      const int frame = static_cast<int>(key.frame);
      if (frame < wind_up && frame >= project.frames.first) start = frame;
    }
    break;
  }
  return start;
}

// Places where a goal's object may have come down as its throw was made: where it is to, and where
// it lies.
std::vector<Vec3> SpotsOf(const ProjectGoal& goal, const ProjectHeldObject& object) {
  std::vector<Vec3> spots = {goal.position_m};
  const auto& curves = object.position.curves;
  for (size_t i = 0; i < curves[0].keys.size(); ++i) {
    const bool is_whole = i < curves[1].keys.size() && i < curves[2].keys.size();
    if (!is_whole || curves[0].keys[i].frame <= goal.frame) continue;
    spots.emplace_back(curves[0].keys[i].value, curves[1].keys[i].value, curves[2].keys[i].value);
    break;
  }
  return spots;
}

// Keys that stand where MakeThrow put them go where it puts them for another spot and style. What
// it put them for is the style, the spot and the frame in which the figure stood that most of them
// agree with.
void Rekey(const ProjectGoal& goal, const ThrowTarget& onto, BodySide side, int wind_up,
           const DynamicsRegion& region, const Animation& animation, const Motion& motion,
           Project* project) {
  constexpr double kSame = 1e-6;  // [degrees]
  const Figure& figure = *animation.figure;
  ThrowPlan plan;
  plan.wind_up = wind_up;
  plan.release = region.first_frame;
  plan.region_last = region.last_frame;
  plan.end = region.last_frame + HomeFrames(animation);
  const std::vector<NamedThrowHinge> hinges = HingesOfThrow(side, figure);
  const std::vector<ThrowKey> keys = KeysOf(plan, hinges, figure, project);
  const auto angle = [&](const ThrowKey& of, const ThrowShape& shape) {
    return WithoutRoundOff(AngleIn(of.phase, *of.hinge, shape, figure));
  };
  const auto stands = [&](const ThrowKey& of, const ThrowShape& shape) {
    return std::abs(of.key->value - angle(of, shape)) <= kSame;
  };
  const std::set<int> frames = {StartOf(wind_up, hinges, *project), wind_up};
  const ProjectHeldObject& object = project->held_objects[static_cast<size_t>(onto.object)];
  std::ptrdiff_t most = 0;
  ThrowShape from, to;
  for (const int stood : frames) {
    const MotionFrame& standing = motion.frames[static_cast<size_t>(stood - animation.first_frame)];
    for (const Vec3& spot : SpotsOf(goal, object)) {
      for (const auto& style : EnumNames<ThrowStyle>::kNames) {
        const ThrowShape shape = ShapeOf(side, style.value, spot, standing, animation);
        const auto count = std::count_if(keys.begin(), keys.end(), [&](const ThrowKey& of) {
          return of.key->value != 0.0 && stands(of, shape);
        });
        if (count <= most) continue;
        most = count;
        from = shape;
        to = ShapeOf(side, *onto.style, CentreOn(onto.spot, onto.object, animation), standing,
                     animation);
      }
    }
  }
  if (most == 0) return;
  for (const ThrowKey& of : keys) {
    if (stands(of, from)) of.key->value = angle(of, to);
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
  SolvedSpan span;
  span.holder = of.holder.number;
  span.region = of.region;
  span.goal = of.goal;
  span.release = of.holder.last;
  span.cleared = region.first_frame;
  if (of.goal && !onto.style) onto.style = project.goals[*of.goal].style;
  const std::optional<int> swings =
      WindUpOf(region, *figure.FindGroup(of.holder.joint), animation, project);
  if (of.goal && swings) {
    span.wind_up = *swings;
    if (side) {
      Rekey(project.goals[*of.goal], onto, *side, *swings, region, animation, motion, &made);
    }
    return SolveThrow(onto, span, animation, std::move(made));
  }
  span.wind_up = region.first_frame;
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
