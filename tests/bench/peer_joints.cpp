#include "tests/bench/peer_joints.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

#include "engine/base/assert.h"
#include "engine/spatial/pose.h"

namespace hazumi::bench {

namespace {

const Vec3& AxisOf(const Figure& figure, const JointGroup& group, int hinge) {
  return figure.joints()[group.first.value() + hinge].axis;
}

Mat3 Turn(const Vec3& axis, double angle) {
  return AxisRotation<double>(axis, std::sin(angle), std::cos(angle));
}

double LastSign(const Figure& figure, const JointGroup& group) {
  const Vec3 z = AxisOf(figure, group, 0).cross(AxisOf(figure, group, 1));
  return z.dot(AxisOf(figure, group, 2)) > 0.0 ? 1.0 : -1.0;
}

}  // namespace

Mat3 HingeFrame(const Figure& figure, const JointGroup& group) {
  Mat3 R;
  if (group.size == 1) {
    R.col(2) = AxisOf(figure, group, 0);
    R.col(0) = R.col(2).unitOrthogonal();
    R.col(1) = R.col(2).cross(R.col(0));
  } else {
    R.col(0) = AxisOf(figure, group, 0);
    R.col(1) = AxisOf(figure, group, 1);
    R.col(2) = R.col(0).cross(R.col(1));
    if (group.size == 3) HAZUMI_DEMAND(R.col(2).cross(AxisOf(figure, group, 2)).norm() < 1e-12);
  }
  HAZUMI_DEMAND(R.isUnitary(1e-12));
  return R;
}

VecX CoordinateSigns(const Figure& figure, Threes threes) {
  VecX signs = VecX::Ones(figure.num_joints());
  if (threes == Threes::kBall) return signs;
  for (const JointGroup& group : figure.groups()) {
    if (group.size == 3) signs[group.last().value()] = LastSign(figure, group);
  }
  return signs;
}

BallJoint::BallJoint(const Figure& figure, const JointGroup& group)
    : first_(group.first.value()),
      frame_(HingeFrame(figure, group)),
      last_sign_(LastSign(figure, group)),
      axis_{AxisOf(figure, group, 0), AxisOf(figure, group, 1), AxisOf(figure, group, 2)} {}

Mat3 BallJoint::Rotation(const VecX& q) const {
  return Turn(axis_[0], q[first_]) * Turn(axis_[1], q[first_ + 1]) * Turn(axis_[2], q[first_ + 2]);
}

Mat3 BallJoint::AxesAt(const VecX& q) const {
  const Mat3 R_1 = Turn(axis_[0], q[first_]);
  Mat3 axes;
  axes << axis_[0], R_1 * axis_[1], R_1 * (Turn(axis_[1], q[first_ + 1]) * axis_[2]);
  return axes;
}

Vec3 BallJoint::AngularVelocity(const VecX& q, const VecX& qd) const {
  return AxesAt(q) * qd.segment<3>(first_);
}

Vec3 BallJoint::Moment(const VecX& q, const VecX& tau) const {
  return AxesAt(q).transpose().partialPivLu().solve(tau.segment<3>(first_));
}

// alpha = axes qdd + (what the turning axes contribute at qdd = 0).
void BallJoint::SetHingeAccelerations(const VecX& q, const VecX& qd, const Vec3& alpha,
                                      VecX* qdd) const {
  const Mat3 axes = AxesAt(q);
  const Vec3 rate = qd.segment<3>(first_);
  const Vec3 w_1 = axes.col(0) * rate[0], w_2 = w_1 + axes.col(1) * rate[1];
  const Vec3 of_axes = w_1.cross(axes.col(1)) * rate[1] + w_2.cross(axes.col(2)) * rate[2];
  qdd->segment<3>(first_) = axes.partialPivLu().solve(alpha - of_axes);
}

// In the hinges' frame R = Rx(q1) Ry(q2) Rz(+-q3).
void BallJoint::SetHingeAngles(const Mat3& R, VecX* q) const {
  const Mat3 xyz = frame_.transpose() * R * frame_;
  (*q)[first_] = std::atan2(-xyz(1, 2), xyz(2, 2));
  (*q)[first_ + 1] = std::atan2(xyz(0, 2), std::hypot(xyz(0, 0), xyz(0, 1)));
  (*q)[first_ + 2] = last_sign_ * std::atan2(-xyz(0, 1), xyz(0, 0));
}

std::vector<BallJoint> BallJoints(const Figure& figure) {
  std::vector<BallJoint> balls;
  for (const JointGroup& group : figure.groups()) {
    if (group.size == 3) balls.emplace_back(figure, group);
  }
  return balls;
}

}  // namespace hazumi::bench
