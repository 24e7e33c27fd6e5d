// An arm whose keys end with the angles q and rates q' as it lets go gives the object the place and
// the velocity of the hand with them (release_pose.cpp). On the way there from the wind-up it moves
// with the least torque (aim_solver.cpp), by keys on the knots of that motion's splines. Then the
// region moves it on with the speed it has. Where the arm's swing moves what carries it, as in a
// flight, the throw is aimed at the spot less the miss, some times over.

#include "engine/makers/throws/solved_throw.h"

#include <algorithm>
#include <cmath>

#include "engine/analysis/object_landing.h"
#include "engine/base/text.h"
#include "engine/collision/distance.h"
#include "engine/dynamics/kinematics.h"
#include "engine/makers/throws/arm_swing.h"
#include "engine/makers/throws/throw_plan.h"
#include "engine/makers/throws/thrown_object.h"
#include "engine/makers/trial_bakes.h"
#include "engine/project/compile.h"
#include "engine/project/edits/curves.h"
#include "engine/project/edits/entries.h"
#include "engine/project/edits/goals.h"
#include "engine/project/edits/keys.h"
#include "engine/spatial/degrees.h"

namespace hazumi::makers {

namespace {

Error InTheWayOf(const std::string& what, bool has_height) {
  return Refusal(
      has_height ? "height" : "x",
      "\"" + what + "\" is in the way; " +
          (has_height ? "give a greater height" : "choose a spot that is open from above"));
}

// The goal of a release; a new one if there is none.
size_t GoalOf(const std::string& object, int release, Project* project) {
  for (size_t i = 0; i < project->goals.size(); ++i) {
    const ProjectGoal& goal = project->goals[i];
    const bool is_throw = goal.kind == GoalKind::kObject && goal.object == object;
    if (is_throw && goal.frame == release) return i;
  }
  ProjectGoal goal;
  goal.name = FreeName("throw", project->goals);
  goal.kind = GoalKind::kObject;
  goal.object = object;
  project->goals.push_back(std::move(goal));
  return project->goals.size() - 1;
}

// Splits the joints of drives as those of their region were split. Drives without joints go.
template <typename IsOfArm>
void SplitDrives(IsOfArm is_of_arm, ProjectRegion* others, ProjectRegion* arm) {
  for (ProjectDrive& drive : others->drives) std::erase_if(drive.joints, is_of_arm);
  for (ProjectDrive& drive : arm->drives) {
    std::erase_if(drive.joints, [&](const JointRef& ref) { return !is_of_arm(ref); });
  }
  for (ProjectRegion* region : {others, arm}) {
    std::erase_if(region->drives, [](const ProjectDrive& drive) { return drive.joints.empty(); });
  }
}

class ThrowSolver {
 public:
  ThrowSolver(const ThrowTarget& target, const SolvedSpan& span, const Animation& before,
              Project project)
      : target_(target),
        span_(span),
        object_(static_cast<size_t>(target.object)),
        figure_(before.figure),
        before_(before),
        spot_(CentreOn(target.spot, target.object, before)),
        project_(std::move(project)) {}

  Result<MadeThrow> Solve() {
    constexpr int kMostCorrections = 6;
    if (!(before_.gravity > 0.0)) {
      return Refusal("object", "without gravity nothing comes down");
    }
    if (auto error = CheckTimes()) return *error;
    SetGoal();
    if (auto error = GiveRegion()) return *error;
    if (auto error = FindArm()) return *error;
    ClearSwing();
    if (auto error = Bake()) return *error;
    for (int i = 0;; ++i) {
      Result<ArmSwing> swing = Swing();
      if (!swing.ok()) return swing.error();
      PutSwing(swing.value());
      if (auto error = Bake()) return *error;
      const Vec3 off = OffPlace(goal_, Path());
      if (off.norm() <= 0.5 * goal_.tolerance) {
        muscle_ = swing.value().muscle;
        break;
      }
      if (i == kMostCorrections) {
        return Error{ErrorCode::kSemantics, "", "x",
                     "it misses the spot by " + FormatShort(100.0 * off.norm()) + " cm"};
      }
      aimed_at_ -= off;
    }
    return Made();
  }

 private:
  ProjectRegion& region() { return project_.regions[span_.region]; }
  ProjectHeldObject& object() { return project_.held_objects[object_]; }

  std::optional<Error> CheckTimes() const {
    if (target_.height && !(*target_.height > 0.0)) {
      return Refusal("height", "it has to rise above the hand: give a height greater than 0");
    }
    if (span_.wind_up < project_.frames.first || span_.wind_up >= span_.release) {
      return Refusal("object", "there is no time to swing before frame " +
                                   std::to_string(span_.release) +
                                   ": let go later, or begin the project earlier");
    }
    return CheckTaken(span_.release);
  }

  // Whether somebody takes the object before a frame in which it still flies, or is held.
  std::optional<Error> CheckTaken(int until) const {
    const ProjectHeldObject& thrown = project_.held_objects[object_];
    for (const HolderSpan& holder : HoldersOf(thrown, project_.frames)) {
      if (holder.number <= span_.holder || holder.first >= until) continue;
      return Refusal("object", holder.joint + " takes \"" + thrown.name + "\" in frame " +
                                   std::to_string(holder.first) + ", before it is down in frame " +
                                   std::to_string(until) + ": pass it on later");
    }
    return std::nullopt;
  }

  void SetGoal() {
    goal_index_ = span_.goal ? *span_.goal : GoalOf(object().name, span_.release, &project_);
    ProjectGoal& goal = project_.goals[goal_index_];
    EndOf(span_.holder, &object()) = span_.release;
    goal.frame = span_.release;
    goal.position_m = spot_;
    goal.height_m = target_.height;
    goal.style = target_.style.value_or(goal.style);
    goal_.name = goal.name;
    goal_.frame = goal.frame;
    goal_.place = aimed_at_ = spot_;
    goal_.tolerance = goal.tolerance_m;
    goal_.thrown = {target_.height, goal.style, before_.gravity};
    const ProjectHeldObject& thrown = object();
    const std::string& joint =
        span_.holder < 0 ? thrown.joint : thrown.holders[static_cast<size_t>(span_.holder)].joint;
    const std::optional<GroupIndex> group = figure_->FindGroup(joint);
    if (group) goal_.joint = figure_->group(*group).last();
  }

  // Has the region begin where the arm lets go. One that moves other limbs, too, keeps these; the
  // arm gets a region of its own.
  std::optional<Error> GiveRegion() {
    const std::vector<bool> moved = JointsOf(region(), *figure_);
    JointIndex first;
    for (JointIndex j = goal_.joint; j.is_valid(); j = figure_->joint(j).parent) {
      if (moved[static_cast<size_t>(j.value())]) first = j;
    }
    if (!first.is_valid()) return Refusal("object", "no dynamics region moves what throws");
    // A trunk that is limp itself would be thrown about by the arm.
    const GroupIndex group = figure_->joint(first).group;
    const BodyRole role = FigureBody(*figure_).PlaceOf(group).role;
    if (role == BodyRole::kSpine || role == BodyRole::kHips) {
      return Refusal("object", "\"" + region().name + "\" moves " + figure_->group(group).name +
                                   ", not only the arm that throws: mark a region of the arm");
    }
    const auto is_of_arm = [&](const JointRef& ref) {
      const auto joints = FindJoints(*figure_, ref.name);
      return joints && figure_->IsBeyond(joints->first, first);
    };
    const auto begin = [&](ProjectRegion* of) {
      of->first_frame = span_.release;
      if (of->last_frame <= span_.release) of->last_frame = span_.release + 1;
      project_.frames.last = std::max(project_.frames.last, of->last_frame);
    };
    const std::vector<JointRef>& joints = region().joints;
    if (std::all_of(joints.begin(), joints.end(), is_of_arm)) {
      begin(&region());
      return std::nullopt;
    }
    ProjectRegion own = region();
    own.identity = {};
    own.name = FreeName("throw", project_.regions);
    std::erase_if(own.joints, [&](const JointRef& ref) { return !is_of_arm(ref); });
    std::erase_if(region().joints, is_of_arm);
    SplitDrives(is_of_arm, &region(), &own);
    begin(&own);
    project_.regions.push_back(std::move(own));
    span_.region = project_.regions.size() - 1;
    return std::nullopt;
  }

  // Finds the hinges that the region leaves free, of those that carry the object.
  std::optional<Error> FindArm() {
    Result<Compiled> compiled = CompileAnimation(project_, nullptr, figure_);
    if (!compiled.ok()) return compiled.error();
    const DynamicsRegion& free = compiled.value().animation.regions[span_.region];
    for (JointIndex j = goal_.joint; j.is_valid(); j = figure_->joint(j).parent) {
      if (std::binary_search(free.joints.begin(), free.joints.end(), j)) arm_.push_back(j);
    }
    std::reverse(arm_.begin(), arm_.end());
    if (!arm_.empty()) return std::nullopt;
    return Refusal("object", "\"" + region().name + "\" leaves no joint of the arm free");
  }

  // Takes keys of the swing before away. The wind-up keeps the rates with which the arm arrives.
  void ClearSwing() {
    for (const JointIndex j : arm_) {
      const Result<ProjectCurve*> curve = CurveNamed(figure_->joint(j).name, *figure_, &project_);
      if (!curve.ok()) continue;
      RemoveKeysIn(span_.wind_up + 1, std::max(span_.release, span_.cleared), curve.value());
      ProjectKey* const key = KeyOn(span_.wind_up, curve.value());
      if (key && key->rate_in) key->rate = key->rate_in;
    }
  }

  std::optional<Error> Bake() {
    Result<Compiled> compiled = CompileAnimation(project_, nullptr, figure_);
    if (!compiled.ok()) return compiled.error();
    animation_ = std::move(compiled.value().animation);
    const HeldObject& thrown = animation_.held_objects[object_];
    for (const Holder& holder : thrown.holders) {
      if (holder.last_frame == span_.release) goal_.offset = holder.offset;
    }
    const Result<const Motion*> motion = bakes_.BakeTo(span_.release, animation_);
    if (!motion.ok()) return motion.error();
    motion_ = motion.value();
    return std::nullopt;
  }

  ThrowPath Path() const {
    return Timed(PathOf(goal_, ArrivalAt(span_.release, *motion_), *figure_));
  }

  // The swing with which it gets there past what stands in between.
  Result<ArmSwing> Swing() {
    constexpr double kHigher = 0.2;  // [m]
    constexpr int kMostTries = 12;
    DynamicsRegion arm;
    arm.first_frame = span_.wind_up;
    arm.last_frame = span_.release;
    arm.joints = arm_;
    std::sort(arm.joints.begin(), arm.joints.end());
    arm.friction.assign(arm.joints.size(), 1.0);
    AimGoal aimed = goal_;
    aimed.place = aimed_at_;
    const double radius = InnerRadius(animation_.held_objects[object_]);
    std::string in_the_way;
    for (int i = 0; i < kMostTries; ++i) {
      Result<ArmSwing> swing = PastTheBody(aimed, arm, radius);
      if (!swing.ok()) return swing;
      const ThrowPath path = Timed(swing.value().path);
      in_the_way = InTheWay(path, radius, animation_);
      if (in_the_way.empty()) {
        goal_.thrown->height = aimed.thrown->height;  // of the path that is proved
        return swing;
      }
      if (target_.height) return InTheWayOf(in_the_way, true);
      const double least = std::max(path.velocity.z(), 0.0);
      const double now = aimed.thrown->height.value_or(0.5 * least * least / animation_.gravity);
      aimed.thrown->height = now + kHigher;
    }
    return InTheWayOf(in_the_way, false);
  }

  // The swing that asks for the smallest share of strength, of those of which the object does not
  // fly through the own body. They keep more and more to the pose of the style; the first one that
  // asks for no more than there is will do.
  Result<ArmSwing> PastTheBody(AimGoal aimed, const DynamicsRegion& arm, double radius) const {
    std::optional<ArmSwing> best;
    std::optional<Error> error;
    for (const double firmness : {1.0, 4.0, 8.0}) {
      if (firmness > 4.0 && best) break;
      aimed.thrown->firmness = firmness;
      Result<ArmSwing> swing = SwingArm(aimed, arm, animation_, *motion_);
      if (!swing.ok()) {
        if (!error) error = swing.error();
      } else if (!HitsBody(swing.value().path, radius)) {
        if (!best || swing.value().muscle < best->muscle) best = swing.value();
        if (best->muscle <= 1.0) break;
      }
    }
    if (best) return *best;
    if (error) return *error;
    return Refusal("x", "thrown so, \"" + animation_.held_objects[object_].name +
                            "\" would fly through the body: choose another style, spot or height");
  }

  // Whether an object flies through the body as it stands while it lets go, but for the arm.
  bool HitsBody(const ThrowPath& path, double radius) const {
    constexpr double kLongest = 0.4, kStep = 0.01, kTouch = 0.005;  // [s, s, m]
    const MotionLimit& at = ArrivalAt(span_.release, *motion_);
    DynamicsWorkspace ws(*figure_);
    ComputePositions(*figure_, at.X_WR, at.q, &ws);
    for (const Link& link : figure_->links()) {
      if (link.joint.is_valid() && figure_->IsBeyond(link.joint, arm_.front())) continue;
      const Pose X =
          link.joint.is_valid() ? Pose{ws.body(link.joint).R, ws.body(link.joint).p} : at.X_WR;
      const Capsule body = {X * link.capsule.a, X * link.capsule.b, link.capsule.radius};
      for (double t = 0.0; t <= kLongest; t += kStep) {
        const Vec3 p =
            path.from + t * path.velocity - Vec3(0.0, 0.0, 0.5 * animation_.gravity * t * t);
        if (SignedDistance(Capsule{p, p, radius}, body).value < -kTouch) return true;
      }
    }
    return false;
  }

  ThrowPath Timed(ThrowPath path) const {
    path.seconds = SecondsDown(path, spot_.z(), animation_.gravity);
    return path;
  }

  void PutSwing(const ArmSwing& swing) {
    const MotionFrame& start =
        motion_->frames[static_cast<size_t>(span_.wind_up - animation_.first_frame)];
    for (size_t i = 0; i < swing.hinges.size(); ++i) {
      const Joint& joint = figure_->joint(swing.hinges[i]);
      const Result<ProjectCurve*> curve = CurveNamed(joint.name, *figure_, &project_);
      if (!curve.ok()) continue;
      const auto put = [&](int frame, double angle, double rate, KeyType type) {
        ProjectKey key;
        if (const ProjectKey* there = KeyOn(frame, *curve.value())) key = *there;
        key.frame = frame;
        key.value = WithoutRoundOff(angle / kDegree);
        key.rate = WithoutRoundOff(rate / kDegree);
        key.rate_in.reset();
        key.interpolation = Interpolation::kCubic;
        key.type = type;
        PutKey(key, curve.value());
      };
      const int j = swing.hinges[i].value();
      const ProjectKey* const first = KeyOn(span_.wind_up, *curve.value());
      put(span_.wind_up, start.before.q[j], start.before.qd[j],
          first ? first->type : KeyType::kKeyframe);
      for (size_t k = 1; k < swing.frames.size(); ++k) {
        put(swing.frames[k], swing.angles(static_cast<int>(i), static_cast<int>(k)),
            swing.rates(static_cast<int>(i), static_cast<int>(k)), KeyType::kBreakdown);
      }
    }
  }

  Result<MadeThrow> Made() {
    MadeThrow made;
    const std::optional<HolderSpan> thrower = ThrowerOf(project_.goals[goal_index_], project_);
    const ThrowPath path = Path();
    made.report.down =
        LieDown(path, spot_, *thrower, animation_, static_cast<int>(object_), &project_);
    if (auto error = CheckTaken(made.report.down)) return *error;
    made.report.region = region().name;
    made.report.release = span_.release;
    made.report.velocity = path.velocity;
    made.report.muscle = muscle_;
    made.project = std::move(project_);
    return made;
  }

  const ThrowTarget& target_;
  SolvedSpan span_;
  size_t object_;
  std::shared_ptr<const Figure> figure_;
  const Animation& before_;
  Vec3 spot_, aimed_at_;
  Project project_;
  Animation animation_;
  std::vector<JointIndex> arm_;  // hinges that swing, from the trunk outwards
  size_t goal_index_ = 0;        // of Project::goals
  AimGoal goal_;
  TrialBakes bakes_;
  const Motion* motion_ = nullptr;
  double muscle_ = 0.0;
};

}  // namespace

Result<MadeThrow> SolveThrow(const ThrowTarget& target, const SolvedSpan& span,
                             const Animation& animation, Project project) {
  return ThrowSolver(target, span, animation, std::move(project)).Solve();
}

}  // namespace hazumi::makers
