#pragma once

// Goals and the regions that can meet them.

#include <vector>

#include "engine/project/checks/joint_names.h"
#include "engine/project/project.h"

namespace hazumi {

// Hinges that a goal names.
inline std::vector<bool> HingesOf(const ProjectGoal& goal, const Figure& figure) {
  const std::vector<JointRef> point = {{goal.joint, false, {}}};
  return JointsOf(goal.kind == GoalKind::kPose ? goal.joints : point, figure);
}

// Whether a region moves a joint of a goal in its frame, or of a point one that carries it.
inline bool Moves(const ProjectRegion& region, const ProjectGoal& goal, const Figure& figure) {
  if (region.mute || goal.frame <= region.first_frame || goal.frame > region.last_frame) {
    return false;
  }
  const std::vector<bool> moved = JointsOf(region, figure), named = HingesOf(goal, figure);
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
