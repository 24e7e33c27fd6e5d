#include "tests/bench/falls.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/dynamics/kinematics.h"
#include "engine/spatial/degrees.h"
#include "tests/bench/peer_joints.h"
#include "tests/unit/bake/loose_human.h"

namespace hazumi::bench {

namespace {

double TurnBetween(const Mat3& a, const Mat3& b) {
  return Eigen::AngleAxisd(Mat3(a.transpose() * b)).angle();
}

}  // namespace

// As it stands, soles on the floor, tilting forwards at 0.3 rad/s.
Animation HumanAboutToFall(double friction) {
  Animation fall = test::LooseHuman(static_cast<int>(30 * kFallSeconds), 0.9024);
  fall.root_keys[kRootAngleY][0].rate = 0.3;
  fall.regions[0].friction.assign(fall.regions[0].joints.size(), friction);
  return fall;
}

MotionLimit StartOfFall(const Animation& fall) {
  MotionLimit start;
  start.q = fall.figure->RestAngles();
  start.qd = VecX::Zero(start.q.size());
  for (int j = 0; j < start.q.size(); ++j) {
    if (fall.joint_keys[j].empty()) continue;
    start.q[j] = fall.joint_keys[j][0].value;
    start.qd[j] = fall.joint_keys[j][0].rate.value_or(0.0);
  }
  start.X_WR.p.z() = fall.root_keys[kRootZ][0].value;
  start.root_w.y() = fall.root_keys[kRootAngleY][0].rate.value();
  return start;
}

double AngleBetween(const Figure& figure, const MotionLimit& a, const MotionLimit& b) {
  double worst = TurnBetween(a.X_WR.R, b.X_WR.R);
  for (const JointGroup& group : figure.groups()) {
    if (group.size == 3) {
      const BallJoint ball(figure, group);
      worst = std::max(worst, TurnBetween(ball.Rotation(a.q), ball.Rotation(b.q)));
      continue;
    }
    for (int j = group.first.value(); j <= group.last().value(); ++j) {
      worst = std::max(worst, std::abs(a.q[j] - b.q[j]));
    }
  }
  return worst;
}

double DepthOf(const Figure& figure, const MotionLimit& at) {
  DynamicsWorkspace ws(figure);
  ComputePositions(figure, at.X_WR, at.q, &ws);
  double depth = 0.0;
  for (const Link& link : figure.links()) {
    const Pose X_WJ =
        link.joint.is_valid() ? Pose{ws.body(link.joint).R, ws.body(link.joint).p} : at.X_WR;
    for (const Vec3& end : {link.capsule.a, link.capsule.b}) {
      depth = std::max(depth, link.capsule.radius - (X_WJ.R * end + X_WJ.p).z());
    }
  }
  return depth;
}

}  // namespace hazumi::bench
