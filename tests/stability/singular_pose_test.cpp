// Poses and bodies for which hinges are not coordinates.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/dynamics/kinematics.h"
#include "tests/support/animations.h"
#include "tests/support/odd_figures.h"
#include "tests/support/released.h"

namespace hazumi::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kFrames = 10;

// The arm held out to the side, exactly where the first and third hinge of y x z line up, and the
// same motion told by hinges x y z. There y and z turn about y and -y, so that the body turns with
// (r_x, r_y - r_z, 0); hinges x y z have the axes x, z, -y.
Animation AtThePole(const Vec3& yxz_rates, Method method) {
  VecX q(7), qd(7);
  q << 0.0, 0.5 * kPi, 0.0, -1.0, 0.0, 0.0, 0.0;
  qd << yxz_rates, 4.0, 1.0, 2.0, 0.0;
  Animation animation = Released(FreeArm7(), q, qd, kFrames, method);
  SetTolerance(&animation, 1e-8);
  return animation;
}

Animation AwayFromThePole(const Vec3& yxz_rates) {
  VecX q(7), qd(7);
  q << 0.5 * kPi, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0;
  qd << yxz_rates[1], 0.0, yxz_rates[2] - yxz_rates[0], 4.0, 1.0, 2.0, 0.0;
  Animation animation = Released(FreeArm7WithShoulderXyz(), q, qd, kFrames, Method::kExact);
  SetTolerance(&animation, 1e-8);
  return animation;
}

Mat3 HandOf(const Animation& animation, const MotionFrame& frame) {
  DynamicsWorkspace ws(*animation.figure);
  ComputePositions(*animation.figure, frame.X_WR, frame.q, &ws);
  return ws.bodies.back().R;
}

TEST(Exact, StartsAtThePoleOfABallJointAsFromAnyOtherPose) {
  const Vec3 rates[] = {{0, 0, 0}, {0, 3, 0}, {2, 5, -1}, {-4, 0, 0}};
  for (const Vec3& rate : rates) {
    const Animation pole = AtThePole(rate, Method::kExact), other = AwayFromThePole(rate);
    const Motion motion = BakeFinite(pole), expected = BakeFinite(other);
    ASSERT_EQ(motion.frames.size(), expected.frames.size());
    for (int f = 0; f <= kFrames; ++f) {
      const MotionFrame &at = motion.frames[f], &wanted = expected.frames[f];
      EXPECT_LE((HandOf(pole, at) - HandOf(other, wanted)).norm(), 1e-7) << f;
      EXPECT_LE((at.q - wanted.q).tail<4>().cwiseAbs().maxCoeff(), 1e-7) << f;
    }
    EXPECT_LE(motion.regions[0].evaluations, 2 * expected.regions[0].evaluations);
  }
}

// Cholesky needs a pivot that is not there.
TEST(Paper, StopsWithAReportAtThePoleOfABallJoint) {
  const Result<Motion> motion = BakeSoundly(AtThePole({2, 5, -1}, Method::kPaper));
  ASSERT_FALSE(motion.ok());
}

// A rod without thickness circling at the angle a to the vertical: cos a = 3 g / (2 L W^2).
struct CirclingRod {
  static constexpr double kLength = 0.5, kAngle = 1.0;
  const double W = std::sqrt(1.5 * 9.81 / (kLength * std::cos(kAngle)));

  Animation Make(Method method) const {
    const VecX q = Vec3(-kAngle, 0.0, 0.0), qd = Vec3(0.0, W * std::sin(kAngle), 0.0);
    Animation animation = Released(ThinRod(kLength), q, qd, 30, method);
    SetTolerance(&animation, 1e-8);
    return animation;
  }

  Vec3 Direction(double t) const {
    const double out = std::sin(kAngle);
    return {out * std::cos(W * t), out * std::sin(W * t), -std::cos(kAngle)};
  }
};

TEST(Exact, LetsAThinRodCircleThoughNothingMovesAboutItsOwnAxis) {
  const CirclingRod rod;
  const Animation animation = rod.Make(Method::kExact);
  const Motion motion = BakeFinite(animation);
  ASSERT_EQ(motion.frames.size(), 31u);
  for (int f = 0; f <= 30; ++f) {
    const Vec3 along = -HandOf(animation, motion.frames[f]).col(2);
    EXPECT_LE((along - rod.Direction(f / 30.0)).norm(), 1e-7) << f;
  }
}

// In one plane, where the lost axis stays that of a hinge.
TEST(Exact, SwingsAThinRodLikeAnyOther) {
  const VecX q = Vec3(-1.0, 0.0, 0.0), qd = Vec3(2.0, 0.0, 0.0);
  Animation thin = Released(ThinRod(1.0), q, qd, 30, Method::kExact);
  Animation chain = Released(Chain(1), q.head(1), qd.head(1), 30, Method::kExact);
  for (Animation* animation : {&thin, &chain}) SetTolerance(animation, 1e-7);
  const Motion motion = BakeFinite(thin), expected = BakeFinite(chain);
  ASSERT_EQ(motion.frames.size(), expected.frames.size());
  // The chain's rod is 2 mm thick: 3e-6 more of inertia.
  EXPECT_NEAR(motion.frames.back().q[0], expected.frames.back().q[0], 2e-5);
}

TEST(Exact, GivesAThinRodNoSpinOfItsOwn) {
  const CirclingRod rod;
  const Animation animation = rod.Make(Method::kExact);
  const Motion motion = BakeFinite(animation);
  DynamicsWorkspace ws(*animation.figure);
  for (const MotionFrame& frame : motion.frames) {
    ComputePositions(*animation.figure, frame.X_WR, frame.q, &ws);
    ComputeVelocities(*animation.figure, Vec3::Zero(), Vec3::Zero(), frame.after.qd, &ws);
    EXPECT_LE(std::abs(ws.bodies.back().w.dot(ws.bodies.back().R.col(2))), 1e-6);
  }
}

TEST(Paper, SaysThatTheAxisOfAThinRodMovesNoMass) {
  const Result<Motion> motion = BakeSoundly(CirclingRod().Make(Method::kPaper));
  ASSERT_FALSE(motion.ok());
  EXPECT_NE(motion.error().message.find("\"ball_z\": it moves no mass"), std::string::npos)
      << motion.error().ToString();
}

}  // namespace
}  // namespace hazumi::test
