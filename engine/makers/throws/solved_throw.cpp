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

// The goal of that throw; a new one if there is none.
ProjectGoal* GoalOf(const std::string& object, int release, Project* project) {
  for (ProjectGoal& goal : project->goals) {
    const bool is_it = goal.kind == GoalKind::kObject && goal.object == object;
    // Nobody may let go any more in the frame of a goal whose release was moved.
    if (is_it && (goal.frame == release || !ThrowerOf(goal, *project))) return &goal;
  }
  ProjectGoal goal;
  goal.name = FreeName("throw", project->goals);
  goal.kind = GoalKind::kObject;
  goal.object = object;
  project->goals.push_back(std::move(goal));
  return &project->goals.back();
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
    SetGoal();
    if (auto error = GiveRegion()) return *error;
    ClearSwing();
    if (auto error = Bake()) return *error;
    if (!(animation_.gravity > 0.0)) {
      return Refusal("object", "without gravity nothing comes down");
    }
    if (auto error = CheckHeight()) return *error;
    for (int i = 0;; ++i) {
      Result<ArmSwing> swing = Swing();
      if (!swing.ok()) return swing.error();
      PutSwing(swing.value());
      if (auto error = Bake()) return *error;
      const VecX off = OffPlace(goal_, Path());
      if (off.norm() <= 0.5 * goal_.tolerance) {
        muscle_ = swing.value().muscle;
        break;
      }
      if (i == kMostCorrections) {
        return Error{ErrorCode::kSemantics, "", "x",
                     "it misses the spot by " + FormatShort(100.0 * off.norm()) + " cm"};
      }
      aimed_at_.head(off.size()) -= off;
    }
    return Made();
  }

 private:
  ProjectRegion& region() { return project_.regions[span_.region]; }
  ProjectHeldObject& object() { return project_.held_objects[object_]; }

  void SetGoal() {
    ProjectGoal* const goal = GoalOf(object().name, span_.release, &project_);
    EndOf(span_.holder, &object()) = span_.release;
    goal->frame = span_.release;
    goal->position_m = spot_;
    goal->height_m = target_.height;
    goal->style = target_.style.value_or(goal->style);
    goal_name_ = goal->name;
    goal_.name = goal->name;
    goal_.frame = goal->frame;
    goal_.place = aimed_at_ = spot_;
    goal_.tolerance = goal->tolerance_m;
    goal_.thrown = {target_.height, goal->style, before_.gravity};
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
    arm_.clear();
    for (JointIndex j = goal_.joint; j.is_valid(); j = figure_->joint(j).parent) {
      if (moved[static_cast<size_t>(j.value())]) arm_.push_back(j);
    }
    std::reverse(arm_.begin(), arm_.end());
    if (arm_.empty()) return Refusal("object", "no dynamics region moves what throws");
    const FigureBody body(*figure_);
    const JointIndex first = arm_.front();
    // A trunk that is limp itself would be thrown about by the arm.
    const BodyRole role = body.PlaceOf(figure_->joint(first).group).role;
    if (role == BodyRole::kSpine || role == BodyRole::kHips) {
      return Refusal("object", "\"" + region().name + "\" moves " +
                                   figure_->group(figure_->joint(first).group).name +
                                   ", not only the arm that throws: mark a region of the arm");
    }
    const auto is_of_arm = [&](const JointRef& ref) {
      const auto joints = FindJoints(*figure_, ref.name);
      return joints && figure_->IsBeyond(joints->first, first);
    };
    const std::vector<JointRef> joints = region().joints;
    if (std::all_of(joints.begin(), joints.end(), is_of_arm)) {
      region().first_frame = span_.release;
      region().last_frame = std::max(region().last_frame, span_.release + 1);
      return std::nullopt;
    }
    ProjectRegion own = region();
    own.identity = {};
    own.name = FreeName("throw", project_.regions);
    own.first_frame = span_.release;
    own.last_frame = std::max(own.last_frame, span_.release + 1);
    std::erase_if(own.joints, [&](const JointRef& ref) { return !is_of_arm(ref); });
    std::erase_if(region().joints, is_of_arm);
    project_.regions.push_back(std::move(own));
    span_.region = project_.regions.size() - 1;
    return std::nullopt;
  }

  // Takes keys of the swing before away. The wind-up keeps the rates with which the arm arrives.
  void ClearSwing() {
    for (const JointIndex j : arm_) {
      const Result<ProjectCurve*> curve = CurveNamed(figure_->joint(j).name, *figure_, &project_);
      if (!curve.ok()) continue;
      RemoveKeysIn(span_.wind_up + 1, span_.release, curve.value());
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
    ThrowPath path = PathOf(goal_, ArrivalAt(span_.release, *motion_), *figure_);
    path.seconds = SecondsDown(path, spot_.z(), animation_.gravity);
    return path;
  }

  std::optional<Error> CheckHeight() const {
    if (!target_.height) return std::nullopt;
    if (!(*target_.height > 0.0)) {
      return Refusal("height", "it has to rise above the hand: give a height greater than 0");
    }
    return std::nullopt;
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
      Result<ArmSwing> swing = SwingArm(aimed, arm, animation_, *motion_);
      if (!swing.ok()) return swing;
      ThrowPath path = swing.value().path;
      path.seconds = SecondsDown(path, spot_.z(), animation_.gravity);
      in_the_way = InTheWay(path, radius, animation_);
      if (in_the_way.empty()) {
        goal_.thrown->height = aimed.thrown->height;
        return swing;
      }
      if (target_.height) return InTheWayOf(in_the_way, true);
      const double least = std::max(path.velocity.z(), 0.0);
      const double now = aimed.thrown->height.value_or(0.5 * least * least / animation_.gravity);
      aimed.thrown->height = now + kHigher;
    }
    return InTheWayOf(in_the_way, false);
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
        const bool is_release = k + 1 == swing.frames.size();
        put(swing.frames[k], swing.angles(static_cast<int>(i), static_cast<int>(k)),
            swing.rates(static_cast<int>(i), static_cast<int>(k)),
            is_release ? KeyType::kKeyframe : KeyType::kBreakdown);
      }
    }
  }

  Result<MadeThrow> Made() {
    const Result<ProjectGoal*> goal = EntryNamed(goal_name_, "goal", &project_.goals);
    if (goal.ok()) goal.value()->height_m = goal_.thrown->height;
    MadeThrow made;
    const std::optional<HolderSpan> thrower = ThrowerOf(*goal.value(), project_);
    const ThrowPath path = Path();
    made.report.down = LieDown(path, spot_, *thrower, span_.release, animation_,
                               static_cast<int>(object_), &project_);
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
  std::string goal_name_;
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
