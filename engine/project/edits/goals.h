#pragma once

// Goals and the regions that can meet them.

#include <optional>
#include <vector>

#include "engine/project/checks/joint_names.h"
#include "engine/project/edits/holders.h"
#include "engine/project/project.h"

namespace hazumi {

// Holder that lets an object go in the frame of a goal of that kind; nothing: nobody does.
inline std::optional<HolderSpan> ThrowerOf(const ProjectGoal& goal, const Project& project) {
  for (const ProjectHeldObject& object : project.held_objects) {
    if (object.name != goal.object) continue;
    for (const HolderSpan& holder : HoldersOf(object, project.frames)) {
      if (holder.is_let_go && holder.last == goal.frame) return holder;
    }
  }
  return std::nullopt;
}

// Hinges that a goal names.
inline std::vector<bool> HingesOf(const ProjectGoal& goal, const Figure& figure,
                                  const Project& project) {
  if (goal.kind == GoalKind::kPose) return JointsOf(goal.joints, figure);
  std::vector<JointRef> named;
  if (goal.kind == GoalKind::kPoint) named.push_back({goal.joint, false, {}});
  const std::optional<HolderSpan> thrower = ThrowerOf(goal, project);
  if (thrower) named.push_back({thrower->joint, false, {}});
  return JointsOf(named, figure);
}

// Whether a region moves a joint of a goal in its frame, or of a point one that carries it; of an
// object whether it moves such a joint from that frame on.
inline bool Moves(const ProjectRegion& region, const ProjectGoal& goal, const Figure& figure,
                  const Project& project) {
  const int first = region.first_frame + (goal.kind == GoalKind::kObject ? 0 : 1);
  if (region.mute || goal.frame < first || goal.frame > region.last_frame) return false;
  const std::vector<bool> moved = JointsOf(region, figure), named = HingesOf(goal, figure, project);
  for (int j = 0; j < figure.num_joints(); ++j) {
    if (!named[static_cast<size_t>(j)]) continue;
    for (JointIndex k(j); k.is_valid(); k = figure.joint(k).parent) {
      if (moved[static_cast<size_t>(k.value())]) return true;
      if (goal.kind == GoalKind::kPose) break;
    }
  }
  return false;
}

}  // namespace hazumi
