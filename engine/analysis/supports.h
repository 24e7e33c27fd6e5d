#pragma once

// Contacts of a figure with unknown forces: soles, hands and other links that touch the scene, and
// hands that grip.

#include <vector>

#include "engine/analysis/touching.h"

namespace hazumi {

// Input of Supports for one frame of a motion.
struct SupportedFrame {
  size_t index = 0;  // index in Motion::frames
  const MotionFrame& frame;
  double animation_frame = 0.0;  // time in frames of the animation [FrameAtRate]
  PlacedFrame placed;
};

// Contact points of each frame of a motion [METHOD 10.2]. A sole, or any link that lies on
// something, can push but not pull, whether it is pinned, held or neither. A pinned or held hand
// that reaches a thin object grips the object and can pull. A figure in flight has no contact
// points.
class Supports {
 public:
  // Requires that the animation outlives this object.
  Supports(const Animation& animation, size_t num_frames, const TouchLimits& limits);

  // Requires AddFour for all frames, then Finish, as Touching does; then PointsAt.
  void AddFour(const double* placed) { touching_.AddFour(placed); }
  void Finish(double frame_time) { touching_.Finish(frame_time); }
  void PointsAt(const SupportedFrame& at, std::vector<ContactPoint>* points) const;

 private:
  bool IsInFlight(const SupportedFrame& at) const;
  bool IsHeld(const ContactPoint& point, const SupportedFrame& at) const;
  bool IsKnown(JointIndex joint, const SceneContacts& contacts) const;
  void AddPin(const SupportedFrame& at, std::vector<ContactPoint>* points) const;
  void AddHolds(const SupportedFrame& at, std::vector<ContactPoint>* points) const;
  // Returns false if no thin object is in reach of the body beyond the joint.
  bool Grip(JointIndex joint, const SupportedFrame& at, std::vector<ContactPoint>* points) const;
  void AddGrip(JointIndex joint, const SupportedFrame& at, std::vector<ContactPoint>* points) const;
  void StandOn(JointIndex joint, const SupportedFrame& at, std::vector<ContactPoint>* points) const;

  const Animation& animation_;
  TouchLimits limits_;
  Touching touching_;
  std::vector<Obstacle> thin_;  // objects of the scene that a hand can close around
};

// Joint of an end of a constraint; invalid: the root.
JointIndex HeldJoint(const ConstraintEnd& end, const Figure& figure);
// Place of the end in the world [m]. The end must not be fixed to the world.
Vec3 HeldPlace(const ConstraintEnd& end, const Figure& figure, const PlacedFrame& placed);

}  // namespace hazumi
