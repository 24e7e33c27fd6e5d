#pragma once

// How the concentric hinges of one group become one joint of a program that refuses, or is slow
// with, massless bodies between them.

#include <array>

#include "engine/figure/figure.h"

namespace hazumi::bench {

// What becomes of a group of three hinges.
enum class Threes { kHinges, kBall };

// The frame, in that of the group's body at angle zero, whose x, y, z axes are the hinges of two or
// three in their order; of a single hinge, z is its axis. The hinges must be orthogonal.
Mat3 HingeFrame(const Figure& figure, const JointGroup& group);

// For each joint 1, or -1 where three hinges that stay hinges are left-handed: the last then turns
// about -z of the frame. A peer's coordinates are these times ours.
VecX CoordinateSigns(const Figure& figure, Threes threes);

// Three hinges as one ball joint: body in parent, all vectors in the parent's axes at angle zero.
class BallJoint {
 public:
  BallJoint(const Figure& figure, const JointGroup& group);

  int first() const { return first_; }  // joint index of the first hinge

  // From the angles and rates of all joints.
  Mat3 Rotation(const VecX& q) const;
  Vec3 AngularVelocity(const VecX& q, const VecX& qd) const;
  // The moment that does the work of the hinges' torques.
  Vec3 Moment(const VecX& q, const VecX& tau) const;
  // Writes the hinges' entries of qdd or q.
  void SetHingeAccelerations(const VecX& q, const VecX& qd, const Vec3& alpha, VecX* qdd) const;
  void SetHingeAngles(const Mat3& R, VecX* q) const;

 private:
  Mat3 AxesAt(const VecX& q) const;  // columns: the turned axes

  int first_;
  Mat3 frame_;
  double last_sign_;
  std::array<Vec3, 3> axis_;
};

// The ball joints of a figure, in the order of its groups.
std::vector<BallJoint> BallJoints(const Figure& figure);

}  // namespace hazumi::bench
