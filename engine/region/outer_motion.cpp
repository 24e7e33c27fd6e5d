// Of a quaternion q and an angular velocity w in the world:  q' = (0, w) q / 2.

#include "engine/region/outer_motion.h"

#include "engine/region/region_layout.h"
#include "engine/spatial/checks.h"

namespace hazumi {

namespace {

using Quaternion = Eigen::Vector4d;         // w, x, y, z
using Rates = Eigen::Matrix<double, 6, 1>;  // v, w

Eigen::Map<Vec3> Three(double* y) { return Eigen::Map<Vec3>(y); }
Eigen::Map<const Vec3> Three(const double* y) { return Eigen::Map<const Vec3>(y); }
Eigen::Map<Quaternion> QuaternionAt(double* y) { return Eigen::Map<Quaternion>(y); }
Eigen::Map<Rates> RatesAt(double* y) { return Eigen::Map<Rates>(y); }

// (0, w) q / 2
Quaternion HalfTurned(const Vec3& w, const double* q) {
  const Vec3 v(q[1], q[2], q[3]);
  const Vec3 turned = 0.5 * (q[0] * w + w.cross(v));
  return {-0.5 * w.dot(v), turned.x(), turned.y(), turned.z()};
}

}  // namespace

void OuterMotion::Jump(const VecX& by) {
  HAZUMI_ASSERT(by.size() == static_cast<Eigen::Index>(3 + 6 * balls.size()));
  anchor.v += by.head<3>();
  for (size_t i = 0; i < balls.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(3 + 6 * i);
    balls[i].v += by.segment<3>(at);
    balls[i].w += by.segment<3>(at + 3);
  }
}

void OuterLayout::Pack(const OuterMotion& motion, double* y) const {
  HAZUMI_ASSERT(num_balls_ == 0 || motion.balls.size() == static_cast<size_t>(num_balls_));
  if (has_anchor_) {
    Three(y) = motion.anchor.p;
    Three(y + 3) = motion.anchor.v;
  }
  for (int i = 0; i < num_balls_; ++i) {
    const BodyMotion& ball = motion.balls[i];
    const Eigen::Quaterniond turn(ball.X_WB.R);
    double* own = y + FirstOf(i);
    Three(own) = ball.X_WB.p;
    QuaternionAt(own + kTurn) = Quaternion(turn.w(), turn.x(), turn.y(), turn.z());
    RatesAt(own + kRates) << ball.v, ball.w;
  }
}

void OuterLayout::Unpack(const double* y, OuterMotion* motion) const {
  HAZUMI_ASSERT(num_balls_ == 0 || motion->balls.size() == static_cast<size_t>(num_balls_));
  if (has_anchor_) {
    motion->anchor.p = Three(y);
    motion->anchor.v = Three(y + 3);
  }
  for (int i = 0; i < num_balls_; ++i) {
    const double* own = y + FirstOf(i);
    BodyMotion& ball = motion->balls[i];
    ball.X_WB = {RotationOfQuaternion(own + kTurn), Three(own)};
    ball.v = Three(own + kRates);
    ball.w = Three(own + kRates + 3);
  }
}

void OuterLayout::MoveOn(const VecX& by, double* y) const {
  HAZUMI_ASSERT(by.size() == num_jumps());
  if (has_anchor_) Three(y) += by.head<3>();
  for (int i = 0; i < num_balls_; ++i) {
    double* own = y + FirstOf(i);
    Three(own) += by.segment<3>(3 + 6 * i);
    QuaternionAt(own + kTurn) += HalfTurned(by.segment<3>(6 + 6 * i), own + kTurn);
  }
}

void OuterLayout::Jump(const VecX& by, double* y) const {
  HAZUMI_ASSERT(by.size() == num_jumps());
  if (has_anchor_) Three(y + 3) += by.head<3>();
  for (int i = 0; i < num_balls_; ++i) {
    RatesAt(y + FirstOf(i) + kRates) += by.segment<6>(3 + 6 * i);
  }
}

void OuterLayout::Derive(const double* y, const VecX& accelerations, double* dy) const {
  HAZUMI_ASSERT(accelerations.size() == num_jumps());
  if (has_anchor_) {
    Three(dy) = Three(y + 3);
    Three(dy + 3) = accelerations.head<3>();
  }
  for (int i = 0; i < num_balls_; ++i) {
    const double* own = y + FirstOf(i);
    double* of_own = dy + FirstOf(i);
    const Vec3 w = Three(own + kRates + 3);
    Three(of_own) = Three(own + kRates);
    QuaternionAt(of_own + kTurn) = HalfTurned(w, own + kTurn);
    RatesAt(of_own + kRates) = accelerations.segment<6>(3 + 6 * i);
  }
}

OuterLayout::Part OuterLayout::PartAt(int component) const {
  HAZUMI_ASSERT(0 <= component && component < size());
  if (component < FirstOf(0)) return component < 3 ? Part::kPlace : Part::kRate;
  const int own = (component - FirstOf(0)) % kBall;
  if (own < kTurn) return Part::kPlace;
  return own < kRates ? Part::kQuaternion : Part::kRate;
}

}  // namespace hazumi
