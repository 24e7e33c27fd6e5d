#pragma once

#include <map>
#include <vector>

#include "engine/bake/pose/root_placement.h"
#include "engine/placement/figure_motion.h"
#include "engine/placement/support.h"
#include "engine/region/ball_axes.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// What the motion that springs pull to asks for.
struct ForwardTorques {
  VecX torques;  // by joint [N m]
  VecX moments;  // of a ball joint: along its frame's axes, by its hinges [N m]
};

// The torques that make a figure move as it would by its keys.
class FeedForward {
 public:
  // Regions of the animation are active, with their friction. The figure must outlive it.
  FeedForward(const Animation& animation, const Figure& figure, const std::vector<int>& active);

  // Supports the figure from now on at the points where it touches the scene in `motion`. Applies
  // to a figure that contacts place. The figure falls if no point touches.
  void StandAsIn(const FigureMotion& motion, const std::vector<SceneObject>& scene);

  // Of a figure whose joints and root's orientation move so: accelerations are read, of all joints;
  // where the hold says so its root is placed by it.
  ForwardTorques Of(FigureMotion motion, const RootHold& hold);

 private:
  // A pin gives the force that hangs the figure on its root otherwise.
  void HangOnPin(JointIndex pin, ForwardTorques* forward);
  void AddMoments(JointIndex pin, ForwardTorques* forward);
  // Supplies the wrench on the stance body by forces at the support points.
  void StandOnSupport(ForwardTorques* forward);

  const Figure& figure_;
  double gravity_;
  VecX friction_;  // rates, by joint [1/s]
  DynamicsWorkspace ws_;
  std::map<GroupIndex, BallAxes> balls_;
  std::vector<SupportPoint> support_;
  JointIndex stance_;  // joint of the fixed body, which carries the largest load
};

}  // namespace hazumi
