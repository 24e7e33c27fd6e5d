#include <algorithm>
#include <utility>

#include "engine/makers/aims/aims.h"
#include "engine/makers/fills/limbs.h"
#include "engine/project/checks/joint_names.h"
#include "engine/project/edits/entries.h"

namespace hazumi::makers {

namespace {

constexpr int kReachFrames = 10;  // of a new region
constexpr double kReachFriction = 0.8;

}  // namespace

Vec3 TipOf(JointIndex joint, const Figure& figure) {
  Vec3 tip = Vec3::Zero();
  for (const Link& link : figure.links()) {
    if (link.joint != joint) continue;
    for (const Vec3& end : {link.capsule.a, link.capsule.b}) {
      const double length = end.norm();
      if (length <= tip.norm()) continue;
      tip = end * ((length + link.capsule.radius) / length);
    }
  }
  return tip;
}

namespace {

// First frame of a region that ends in a frame: a few frames before, and behind regions that end
// meanwhile.
int FirstFrame(const ProjectGoal& goal, const std::vector<JointRef>& joints, const Figure& figure,
               const Project& project) {
  int first = std::max(project.frames.first, goal.frame - kReachFrames);
  const std::vector<bool> own = JointsOf(joints, figure);
  for (const ProjectRegion& region : project.regions) {
    const std::vector<bool> others = JointsOf(region, figure);
    bool shares = false;
    for (size_t j = 0; j < own.size(); ++j) shares |= own[j] && others[j];
    if (shares && region.last_frame < goal.frame) first = std::max(first, region.last_frame);
  }
  return first;
}

// Joint with which the limb of a joint begins; the joint itself, if it is of no limb.
GroupIndex FirstOfLimb(GroupIndex joint, const Figure& figure) {
  for (const Limb& limb : LimbsOf(figure)) {
    if (std::find(limb.begin(), limb.end(), joint) != limb.end()) return limb.front();
  }
  return joint;
}

// A region of the joint's limb, from a few frames before the goal's frame up to it.
Result<ProjectRegion> NewRegion(const ProjectGoal& goal, GroupIndex joint, const Figure& figure,
                                const Project& project) {
  ProjectRegion region;
  region.last_frame = goal.frame;
  region.joints = {{figure.group(FirstOfLimb(joint, figure)).name, true, {}}};
  region.first_frame = FirstFrame(goal, region.joints, figure, project);
  if (region.first_frame >= region.last_frame) {
    return Refusal("frame", "there is no time before frame " + std::to_string(goal.frame) +
                                ": reach in a later frame");
  }
  region.friction.default_factor = kReachFriction;
  region.limit_tangents = true;
  if (project.solver.method != Method::kExact) region.method = Method::kExact;
  region.name = FreeName("reach", project.regions);
  return region;
}

}  // namespace

Result<MadeAim> MakeReach(const ReachTarget& target, const Project& project,
                          std::shared_ptr<const Figure> figure, const std::atomic<bool>* cancel) {
  const auto joint = FindJoints(*figure, target.joint);
  if (!joint) return Refusal("joint", "no joint \"" + target.joint + "\"");
  Project with_goal = project;
  const auto is_same = [&](const ProjectGoal& goal) {
    return goal.kind == GoalKind::kPoint && goal.joint == target.joint &&
           goal.frame == target.frame;
  };
  auto goal = std::find_if(with_goal.goals.begin(), with_goal.goals.end(), is_same);
  const bool is_new = goal == with_goal.goals.end();
  if (is_new) {
    ProjectGoal fresh;
    fresh.name = FreeName("reach", with_goal.goals);
    fresh.kind = GoalKind::kPoint;
    fresh.frame = target.frame;
    fresh.joint = target.joint;
    fresh.rests = true;
    fresh.offset_m = TipOf(JointIndex(joint->end.value() - 1), *figure);
    with_goal.goals.push_back(std::move(fresh));
    goal = std::prev(with_goal.goals.end());
  }
  goal->position_m = target.position;
  goal->rests = target.rests.value_or(goal->rests);
  if (!RegionOf(*goal, *figure, with_goal)) {
    Result<ProjectRegion> region = NewRegion(*goal, joint->group, *figure, with_goal);
    if (!region.ok()) return region.error();
    with_goal.regions.push_back(std::move(region).value());
  }
  const std::string name = goal->name;
  Result<MadeAim> made = MakeAim(name, with_goal, figure, cancel);
  const bool is_missed = !made.ok() && made.error().code == ErrorCode::kSemantics;
  if (!is_missed || !is_new || target.rests) return made;
  // A limb that cannot stop there may pass.
  goal->rests = false;
  return MakeAim(name, with_goal, std::move(figure), cancel);
}

}  // namespace hazumi::makers
