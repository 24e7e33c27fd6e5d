#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/base/assert.h"
#include "engine/base/text.h"
#include "engine/figure/strength.h"
#include "engine/makers/aims/aims.h"
#include "engine/makers/aims/torque_search.h"
#include "engine/makers/trial_bakes.h"
#include "engine/project/checks/joint_names.h"
#include "engine/project/compile.h"
#include "engine/project/edits/entries.h"
#include "engine/project/edits/goals.h"
#include "engine/spatial/degrees.h"
#include "engine/timeline/curve_track.h"

namespace hazumi::makers {

namespace {

class AimMaker {
 public:
  AimMaker(const Project& project, const std::atomic<bool>* cancel)
      : made_{project, {}}, cancel_(cancel) {}

  Result<MadeAim> Make(const std::string& name, std::shared_ptr<const Figure> figure) {
    const Result<ProjectGoal*> goal = EntryNamed(name, "goal", &made_.project.goals);
    if (!goal.ok()) return goal.error();
    HAZUMI_DEMAND(goal.value()->kind != GoalKind::kObject);
    if (!figure) {
      const Result<Compiled> compiled = CompileAnimation(made_.project, cancel_);
      if (!compiled.ok()) return compiled.error();
      figure = compiled.value().animation.figure;
    }
    const ProjectRegion* region = RegionOf(*goal.value(), *figure, made_.project);
    if (!region) return NoRegion(*goal.value());
    const size_t index = static_cast<size_t>(region - made_.project.regions.data());
    LetLoose(&made_.project.regions[index]);
    const Result<Compiled> compiled = CompileAnimation(made_.project, cancel_, figure);
    if (!compiled.ok()) return compiled.error();
    const Animation& animation = compiled.value().animation;
    if (animation.regions[index].method != Method::kExact) {
      return Refusal("goal", "\"" + region->name + "\" is solved by method paper; aims need exact");
    }
    TorqueAim aim;
    aim.region = index;
    if (auto error = AskFor(animation, &aim)) return *error;
    const Result<FoundTorques> found = FindTorques(aim, animation, cancel_);
    if (!found.ok()) return found.error();
    made_.report.region = region->name;
    made_.report.is_loose = found.value().torques.empty();
    made_.report.bakes = found.value().bakes;
    made_.report.iterations = found.value().iterations;
    Put(found.value(), *figure, name, &made_.project.regions[index]);
    return Prove(aim, found.value().torques, figure);
  }

 private:
  static Error NoRegion(const ProjectGoal& goal) {
    const std::string joint = goal.kind == GoalKind::kPoint ? goal.joint
                              : goal.joints.empty()         ? std::string()
                                                            : goal.joints[0].name;
    return Refusal("goal", "no dynamics region moves " + joint + " in frame " +
                               std::to_string(goal.frame) +
                               ": mark one that begins before it and ends there or later");
  }

  static Error NothingLimp(const ProjectGoal& goal, const ProjectRegion& region) {
    return Refusal("goal", "\"" + region.name + "\" leaves no joint of \"" + goal.name +
                               "\" limp: take a drive or friction 0 away from one");
  }

  // Another region that moves joints of the goal; null: there is none.
  const ProjectRegion* OtherRegionOf(const ProjectGoal& goal, const ProjectRegion& region,
                                     const Figure& figure) const {
    for (const ProjectRegion& other : made_.project.regions) {
      if (&other != &region && goal.kind == GoalKind::kPose &&
          Moves(other, goal, figure, made_.project)) {
        return &other;
      }
    }
    return nullptr;
  }

  std::optional<Error> AskForPose(const ProjectGoal& goal, const std::vector<char>& limp,
                                  const Animation& animation, AimGoal* asked) const {
    const Figure& figure = *animation.figure;
    const std::vector<bool> hinges = HingesOf(goal, figure, made_.project);
    for (int j = 0; j < figure.num_joints(); ++j) {
      const Joint& joint = figure.joint(JointIndex(j));
      if (!hinges[static_cast<size_t>(j)] || !limp[static_cast<size_t>(j)]) continue;
      CurveTrack curve(&animation.joint_keys[static_cast<size_t>(j)], animation.rate, joint.rest,
                       {});
      const double angle = curve.At(goal.frame).value;
      const double beyond = std::max(angle - joint.upper, joint.lower - angle);
      if (beyond > goal.tolerance_deg * kDegree) {
        return Refusal("goal", "\"" + goal.name + "\" asks " + joint.name + " to be " +
                                   FormatShort(beyond / kDegree) +
                                   "° beyond its limit: change its key in frame " +
                                   std::to_string(goal.frame));
      }
      asked->angles.push_back({JointIndex(j), std::clamp(angle, joint.lower, joint.upper)});
    }
    asked->tolerance = goal.tolerance_deg * kDegree;
    return std::nullopt;
  }

  static std::optional<Error> AskForPoint(const ProjectGoal& goal, const Figure& figure,
                                          AimGoal* asked) {
    const auto joint = FindJoints(figure, goal.joint);
    if (!joint) return Refusal("joint", "no joint \"" + goal.joint + "\"");
    asked->joint = JointIndex(joint->end.value() - 1);
    asked->offset = goal.offset_m;
    asked->place = goal.position_m;
    asked->tolerance = goal.tolerance_m;
    return std::nullopt;
  }

  // Asks for all goals of the region.
  std::optional<Error> AskFor(const Animation& animation, TorqueAim* aim) {
    const Figure& figure = *animation.figure;
    const ProjectRegion& region = made_.project.regions[aim->region];
    const std::vector<char> limp = LimpHinges(animation.regions[aim->region], figure);
    for (const ProjectGoal& goal : made_.project.goals) {
      if (goal.kind == GoalKind::kObject) continue;  // by throws
      if (RegionOf(goal, figure, made_.project) != &region) continue;
      if (const ProjectRegion* other = OtherRegionOf(goal, region, figure)) {
        return Refusal("goal", "\"" + goal.name + "\" asks for joints of the regions \"" +
                                   region.name + "\" and \"" + other->name +
                                   "\": make a goal for each");
      }
      AimGoal asked;
      asked.name = goal.name;
      asked.frame = goal.frame;
      asked.rests = goal.rests;
      std::optional<Error> error;
      if (goal.kind == GoalKind::kPose) error = AskForPose(goal, limp, animation, &asked);
      if (goal.kind == GoalKind::kPoint) error = AskForPoint(goal, figure, &asked);
      if (error) return error;
      if (goal.kind == GoalKind::kPose && asked.angles.empty()) return NothingLimp(goal, region);
      aim->goals.push_back(std::move(asked));
    }
    return std::nullopt;
  }

  // One drive for each hinge.
  static void Put(const FoundTorques& found, const Figure& figure, const std::string& goal,
                  ProjectRegion* region) {
    for (const HingeTorque& torque : found.torques) {
      ProjectDrive drive;
      drive.kind = DriveKind::kTorque;
      drive.joints = {{figure.joint(torque.hinge).name, false, {}}};
      drive.solved_by = goal;
      for (const Key& key : torque.keys) {
        ProjectKey own;
        own.frame = key.frame;
        own.value = key.value;
        own.interpolation = key.interpolation;
        drive.torque.keys.push_back(own);
      }
      region->drives.push_back(std::move(drive));
    }
  }

  // One bake of what is returned says what it does.
  Result<MadeAim> Prove(const TorqueAim& aim, const std::vector<HingeTorque>& torques,
                        std::shared_ptr<const Figure> figure) {
    const Result<Compiled> compiled = CompileAnimation(made_.project, cancel_, std::move(figure));
    if (!compiled.ok()) return compiled.error();
    const Animation& animation = compiled.value().animation;
    TrialBakes bakes;
    int last = 0;
    for (const AimGoal& goal : aim.goals) last = std::max(last, goal.frame);
    const Result<const Motion*> motion = bakes.BakeTo(last, animation);
    if (!motion.ok()) return motion.error();
    for (const AimGoal& goal : aim.goals) {
      const GoalMiss miss =
          MissOf(goal, animation.regions[aim.region], *animation.figure, *motion.value());
      GoalMissed missed = {goal.name, miss.angle, miss.distance, miss.rate, {}};
      if (miss.joint.is_valid()) missed.joint = animation.figure->joint(miss.joint).name;
      made_.report.goals.push_back(missed);
      if (!miss.IsMet(goal)) return Missed(goal, missed);
    }
    FindStrongest(torques, animation, *motion.value(), last);
    return std::move(made_);
  }

  static Error Missed(const AimGoal& goal, const GoalMissed& missed) {
    std::string text;
    if (missed.distance > goal.tolerance) {
      text = FormatShort(100.0 * missed.distance) + " cm short";
    } else if (missed.angle > goal.tolerance) {
      text = missed.joint + " misses by " + FormatShort(missed.angle / kDegree) + "°";
    } else {
      text = "it still turns at " + FormatShort(missed.rate / kDegree) + "°/s";
    }
    return {ErrorCode::kSemantics, "", "goal",
            "\"" + missed.goal + "\" is not reached in frame " + std::to_string(goal.frame) + ": " +
                text};
  }

  // Finds the largest share of a strength on whole frames up to the last goal.
  void FindStrongest(const std::vector<HingeTorque>& torques, const Animation& animation,
                     const Motion& motion, int last) {
    for (const HingeTorque& torque : torques) {
      const Joint& joint = animation.figure->joint(torque.hinge);
      if (!joint.strength) continue;
      CurveTrack curve(&torque.keys, animation.rate, 0.0, {});
      for (int f = static_cast<int>(torque.keys.front().frame); f <= last; ++f) {
        const MotionFrame& frame = motion.frames[static_cast<size_t>(f - motion.frames[0].frame)];
        const MotionLimit& at = f < last ? frame.after : frame.before;
        const int j = torque.hinge.value();
        const double tau = curve.At(f).value;
        const StrengthLimits most = joint.strength->At(at.q[j], at.qd[j]);
        const double share = std::abs(tau) / (tau > 0.0 ? most.positive : most.negative).torque;
        if (share <= made_.report.muscle) continue;
        made_.report.muscle = share;
        made_.report.strongest = joint.name;
        made_.report.frame = f;
      }
    }
  }

  MadeAim made_;
  const std::atomic<bool>* cancel_;
};

}  // namespace

void LetLoose(ProjectRegion* region) {
  std::erase_if(region->drives, [](const ProjectDrive& drive) { return !drive.solved_by.empty(); });
}

const ProjectRegion* RegionOf(const ProjectGoal& goal, const Figure& figure,
                              const Project& project) {
  const auto region =
      std::find_if(project.regions.begin(), project.regions.end(),
                   [&](const ProjectRegion& each) { return Moves(each, goal, figure, project); });
  return region == project.regions.end() ? nullptr : &*region;
}

Result<MadeAim> MakeAim(const std::string& goal, const Project& project,
                        std::shared_ptr<const Figure> figure, const std::atomic<bool>* cancel) {
  return AimMaker(project, cancel).Make(goal, std::move(figure));
}

}  // namespace hazumi::makers
