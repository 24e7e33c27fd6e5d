#pragma once

// What may push a figure besides the forces that are known: soles, hands and whatever else touches
// the scene, and hands that grip.

#include <vector>

#include "engine/analysis/touching.h"

namespace hazumi {

// One frame of a motion, as Supports sees it.
struct SupportedFrame {
  size_t index = 0;  // in Motion::frames
  const MotionFrame& frame;
  double animation_frame = 0.0;  // its time in frames of the animation [FrameAtRate]
  PlacedFrame placed;
};

// The contact points of each frame of a motion [METHOD 10.2]. A sole, and whatever lies on
// something, can push and not pull, whether it is pinned, held or neither. A pinned or held hand
// that reaches something thin grips it, and can pull. A figure in flight has none.
class Supports {
 public:
  // The animation must outlive it.
  Supports(const Animation& animation, size_t num_frames, const TouchLimits& limits);

  // First AddFour for all frames, then Finish, as those of Touching; then PointsAt.
  void AddFour(const double* placed) { touching_.AddFour(placed); }
  void Finish(double frame_time) { touching_.Finish(frame_time); }
  void PointsAt(const SupportedFrame& at, std::vector<ContactPoint>* points) const;

 private:
  bool IsInFlight(const SupportedFrame& at) const;
  bool IsHeld(const ContactPoint& point, const SupportedFrame& at) const;
  bool IsKnown(JointIndex joint, const SceneContacts& contacts) const;
  void AddPin(const SupportedFrame& at, std::vector<ContactPoint>* points) const;
  void AddHolds(const SupportedFrame& at, std::vector<ContactPoint>* points) const;
  // False: nothing thin is in reach of the body beyond the joint.
  bool Grip(JointIndex joint, const SupportedFrame& at, std::vector<ContactPoint>* points) const;
  void AddGrip(JointIndex joint, const SupportedFrame& at, std::vector<ContactPoint>* points) const;
  void StandOn(JointIndex joint, const SupportedFrame& at, std::vector<ContactPoint>* points) const;

  const Animation& animation_;
  TouchLimits limits_;
  Touching touching_;
  std::vector<Obstacle> thin_;  // of the scene: what a hand can close around
};

// The joint that an end of a constraint is on: invalid where that is the root.
JointIndex HeldJoint(const ConstraintEnd& end, const Figure& figure);
// The end's place in the world [m]; of an end that is not in the world itself.
Vec3 HeldPlace(const ConstraintEnd& end, const Figure& figure, const PlacedFrame& placed);

}  // namespace hazumi
