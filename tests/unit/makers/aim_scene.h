#pragma once

// Scenes in which limbs are aimed.

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "engine/bake/bake.h"
#include "engine/project/checks/joint_names.h"
#include "engine/project/compile.h"
#include "engine/project/edits/curves.h"
#include "engine/project/edits/keys.h"
#include "engine/project/project_reader.h"
#include "engine/spatial/degrees.h"

namespace hazumi::test {

// An example with a region of its own.
struct AimScene {
  Project project;
  Animation animation;
  int last = 0;

  AimScene(const char* file, int first, int end, const char* joints) : last(end) {
    project = LoadProject(std::string(HAZUMI_SOURCE_DIR "/assets/examples/") + file).value();
    ProjectRegion region;
    region.name = "aimed";
    region.first_frame = first;
    region.last_frame = end;
    region.joints = {{joints, true, {}}};
    region.friction.default_factor = 0.8;
    project.regions = {region};
    animation = CompileAnimation(project).value().animation;
  }
  const Figure& figure() const { return *animation.figure; }
  const std::vector<JointIndex>& hinges() const { return animation.regions[0].joints; }

  // A goal that these hinges have these angles [degrees] as the region ends.
  Project WithPose(const std::vector<double>& angles, bool rests = false) const {
    Project aimed = project;
    ProjectGoal goal;
    goal.name = "meet";
    goal.frame = last;
    goal.rests = rests;
    for (size_t i = 0; i < hinges().size(); ++i) {
      const std::string& name = figure().joint(hinges()[i]).name;
      ProjectKey key;
      key.frame = last;
      key.value = angles[i];
      PutKey(key, CurveNamed(name, figure(), &aimed).value());
      goal.joints.push_back({name, false, {}});
    }
    aimed.goals = {goal};
    return aimed;
  }
  Project WithPoint(const char* joint, const Vec3& offset, const Vec3& position) const {
    Project aimed = project;
    ProjectGoal goal;
    goal.name = "touch";
    goal.kind = GoalKind::kPoint;
    goal.frame = last;
    goal.joint = joint;
    goal.offset_m = offset;
    goal.position_m = position;
    aimed.goals = {goal};
    return aimed;
  }

  // Angles within the limits [degrees].
  std::vector<double> RandomPose(std::mt19937* random) const {
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::vector<double> angles;
    for (const JointIndex j : hinges()) {
      const Joint& joint = figure().joint(j);
      angles.push_back((joint.lower + share(*random) * (joint.upper - joint.lower)) / kDegree);
    }
    return angles;
  }
};

inline Motion MotionOf(const Project& project) {
  return Bake(CompileAnimation(project).value().animation).value();
}
inline const MotionFrame& At(int frame, const Motion& motion) {
  return motion.frames[static_cast<size_t>(frame - motion.frames[0].frame)];
}

}  // namespace hazumi::test
