#pragma once

#include <vector>

#include "engine/analysis/frame_dynamics.h"
#include "engine/dynamics/workspace.h"
#include "engine/region/forces/force_law.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// What a force from outside does to the body beyond a joint, an invalid one being the root: a force
// at p and a moment. World axes [m, N, N m].
struct OuterPush {
  JointIndex joint;
  Vec3 p = Vec3::Zero();
  Wrench push;
};

// What the forces of an animation do to a figure that moves as a frame says: the laws of regions
// [METHOD 9], asked of all of its bodies.
class OuterPushes {
 public:
  // The animation must outlive it.
  explicit OuterPushes(const Animation& animation);

  // At time t [s]. `loaded`: the figure with what it holds. Stays until the next call.
  const std::vector<OuterPush>& At(double t, const MovedFrame& at, const Figure& loaded);

 private:
  void Place(const MovedFrame& at);

  const Animation& animation_;
  RegionModel model_;  // all joints free
  RegionLayout layout_;
  NodeKinematics kinematics_;
  std::vector<NodePlace> places_;     // by node
  std::vector<JointIndex> joint_of_;  // by node: the last of its joints
  DynamicsWorkspace ws_;
  std::vector<OuterPush> found_;
};

}  // namespace hazumi
