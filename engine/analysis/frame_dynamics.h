#pragma once

#include <memory>
#include <vector>

#include "engine/analysis/placed_frames.h"
#include "engine/bake/motion.h"
#include "engine/dynamics/kinematics.h"
#include "engine/spatial/wrench.h"
#include "engine/timeline/animation.h"

namespace hazumi {

// Where the figure is in a frame, how fast and how much faster it gets: what is pointed at stays
// elsewhere.
struct MovedFrame {
  const Pose* X_WR = nullptr;
  const double *q = nullptr, *qd = nullptr, *qdd = nullptr;  // by JointIndex [rad, rad/s, rad/s^2]
  RootMotion root;
};

// What a motion asks of a figure with what it holds, hung on its root, in four frames at once.
class FrameDynamics {
 public:
  // Both must outlive it; `placed` has all frames.
  FrameDynamics(const Animation& animation, const PlacedFrames& placed,
                const EffortKernels& kernels = BestEffortKernels());
  FrameDynamics(const FrameDynamics&) = delete;

  // Each of four lanes, then Demand of the first one's frame.
  void Set(size_t lane, const MotionFrame& frame, const MovedFrame& at);
  void Demand(size_t first_frame);

  // What the root needs, at its origin, less what pushes.
  const Wrench& needed(size_t lane) const { return needed_[lane]; }
  // Something outside pushes the body beyond `joint` at p: with it the hinges between there and the
  // root need not give that [principle of virtual work]. An invalid joint is the root.
  void Push(size_t lane, JointIndex joint, const Vec3& p, const Wrench& push);

  // What the hinges give then, by JointIndex [N m].
  void FindTorques();
  VecX torques(size_t lane) const;
  const double* torques() const { return torques_.data(); }  // by joint and frame

  // With what it holds.
  const Figure& figure(size_t lane) const { return loaded_[lane]->figure; }

 private:
  struct Loaded {
    std::vector<ObjectPose> objects;
    Figure figure;
  };
  void Load(size_t lane, const MotionFrame& frame);

  const Animation& animation_;
  const PlacedFrames& placed_;
  EffortKernels kernels_;
  std::shared_ptr<const Loaded> latest_, loaded_[4];
  LaneArray inertias_, motions_, loads_, needs_, torques_;
  FourMotions four_;
  Wrench needed_[4];
  Vec3 p_root_[4];
};

}  // namespace hazumi
