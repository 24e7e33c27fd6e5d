// Pushes: what an impulse does at the instant of its frame.

#include <gtest/gtest.h>

#include <cmath>

#include "engine/dynamics/kinematics.h"
#include "tests/support/compare.h"
#include "tests/support/figures.h"
#include "tests/support/momentum.h"
#include "tests/unit/bake/force_cases.h"

namespace hazumi::test {
namespace {

TEST(PushBake, APushGivesAFreeRodVelocityAndSpin) {
  Animation animation = Flying(FreeRod(), 0.0);
  SetRoot(&animation, kRootAngleZ, 0.7, 0.0);
  SetRoot(&animation, kRootAngleY, -0.4, 0.0);
  SetRoot(&animation, kRootX, 0.1, 0.3);
  const PushForce push = {{{}, Vec3(0.3, 0.01, -0.02)}, Vec3(0.4, -1.1, 0.8)};
  AddForce(&animation, 12, 13, push);
  const Motion motion = BakeOrFail(animation);
  const MotionFrame& hit = motion.frames[12];
  const Mat3 I = hit.X_WR.R * animation.figure->root_body().I_com * hit.X_WR.R.transpose();
  const Vec3 w = I.inverse() * (hit.X_WR.R * push.at.offset).cross(push.impulse);
  const Vec3 v = Vec3(0.3, 0.0, 0.0) + push.impulse / kMass;
  EXPECT_LT(hit.before.root_w.norm(), 1e-12);
  EXPECT_LT((hit.after.root_w - w).norm(), 1e-9);
  EXPECT_LT((hit.after.root_v - v).norm(), 1e-9);
  EXPECT_GT(w.norm(), 1.0);
  const MotionFrame& last = motion.frames[30];
  EXPECT_LT((last.X_WR.p - hit.X_WR.p - 0.6 * v).norm(), 1e-9);
}

// A human whose arms swing: what comes in is the impulse, and its moment about the centre of mass.
TEST(PushBake, APushInFlightChangesMomentumByTheImpulseAndItsMoment) {
  Animation animation = Exact(Human37(), kG);
  AddGravity(&animation, 0, 30);
  FreeAll(&animation, {"r_shoulder", "l_shoulder"});
  SetRoot(&animation, kRootZ, 5.0, 3.0);
  SetRoot(&animation, kRootAngleY, 0.2, 3.0);
  double rate = 1.0;
  for (const JointIndex j : animation.regions[0].joints) {
    animation.joint_keys[j.value()] = {{0, 0.1 * rate, rate, kHold}};
    rate = std::fmod(2.7 * rate + 0.9, 3.0) - 1.0;
  }
  const PushForce push = {{GroupOf(animation, "r_elbow"), Vec3(0.0, 0.02, -0.2)},
                          Vec3(1.0, -2.0, 4.0)};
  AddForce(&animation, 9, 10, push);
  const Motion motion = BakeOrFail(animation);
  const MotionFrame& hit = motion.frames[9];
  const Momentum before = MomentumOf(*animation.figure, hit.before);
  const Momentum after = MomentumOf(*animation.figure, hit.after);
  DynamicsWorkspace ws(*animation.figure);
  ComputePositions(*animation.figure, hit.X_WR, hit.q, &ws);
  const BodyScratch& body = ws.body(animation.figure->group(*push.at.joint).last());
  const Vec3 arm = body.p + body.R * push.at.offset - before.com;
  EXPECT_LT((after.mass * (after.com_v - before.com_v) - push.impulse).norm(), 1e-9);
  EXPECT_LT((after.L - before.L - arm.cross(push.impulse)).norm(), 1e-9);
  const Momentum end = MomentumOf(*animation.figure, motion.frames[30].before);
  EXPECT_LT((end.L - after.L).norm(), 1e-7 * after.L.norm());
  const Vec3 fallen = after.com + 0.7 * after.com_v - 0.5 * kG * 0.49 * Vec3::UnitZ();
  EXPECT_LT((end.com - fallen).norm(), 1e-9);
}

// On links that hang on what stays: the energy that comes in is impulse times mean velocity.
TEST(PushBake, TheWorkOfAPushIsItsImpulseTimesTheMeanVelocityOfItsPoint) {
  Animation animation = Exact(Human37(), kG);
  AddRegion(&animation, "arm", 0, 30, {"r_shoulder"}, 0.95).method = Method::kExact;
  const PushForce push = {{GroupOf(animation, "r_elbow"), Vec3(0.0, 0.02, -0.2)},
                          Vec3(1.0, -0.5, 0.3)};
  AddForce(&animation, 11, 12, push);
  const Motion motion = BakeOrFail(animation, {{}, nullptr, true});
  const MotionFrame& hit = motion.frames[11];
  Vec3 sum = Vec3::Zero();
  DynamicsWorkspace ws(*animation.figure);
  ComputePositions(*animation.figure, hit.X_WR, hit.q, &ws);
  for (const MotionLimit* side : {&hit.before, &hit.after}) {
    ComputeVelocities(*animation.figure, Vec3::Zero(), Vec3::Zero(), side->qd, &ws);
    const BodyScratch& body = ws.body(animation.figure->group(*push.at.joint).last());
    sum += body.v + body.w.cross(body.R * push.at.offset);
  }
  const double work = 0.5 * push.impulse.dot(sum);
  const EnergyBalance energy = motion.regions[0].energy.value();
  EXPECT_NEAR(energy.WorkOf("push"), work, 1e-8);
  EXPECT_GT(work, 0.1);
  EXPECT_LT(std::abs(energy.residual()), 1e-6);
}

// A knee on its limit is pushed against it: it stays, and the leg turns as one body.
TEST(PushBake, APushDoesNotGoThroughALimit) {
  FigureSpec spec;
  spec.name = "leg";
  spec.root_name = "base";
  spec.root_links = {Rod("base", Vec3::Zero(), Vec3::Zero())};
  spec.root_links[0].radius = 0.1;
  JointSpec hip, knee;
  hip.name = "hip";
  hip.parent = "base";
  hip.hinges = {{"", Vec3::UnitZ(), -10.0, 10.0, 0.0}};
  hip.links = {Rod("thigh", Vec3::Zero(), kLength * Vec3::UnitX())};
  knee = hip;
  knee.name = "knee";
  knee.parent = "hip";
  knee.offset = kLength * Vec3::UnitX();
  knee.hinges = {{"", Vec3::UnitZ(), 0.0, 2.0, 0.0}};
  knee.links[0].name = "shank";
  spec.joints = {hip, knee};
  Animation animation = Exact(BuildFigure(spec).value(), 0.0);
  AddRegion(&animation, "leg", 0, 30, {"hip"}).method = Method::kExact;
  const double impulse = 0.7;
  AddForce(
      &animation, 10, 11,
      PushForce{{GroupOf(animation, "knee"), kLength * Vec3::UnitX()}, -impulse * Vec3::UnitY()});
  const Motion motion = BakeOrFail(animation);
  const double I_com = animation.figure->body(JointIndex(0)).I_com(2, 2);
  const double I = 2.0 * I_com + kMass * kLength * kLength * (0.25 + 2.25);
  const double w = -impulse * 2.0 * kLength / I;
  for (int frame = 11; frame < 30; ++frame) {
    EXPECT_NEAR(motion.frames[frame].q[1], 0.0, 1e-12);
    EXPECT_NEAR(motion.frames[frame].after.qd[0], w, 1e-9);
  }
}

TEST(PushBake, APushOnWhatNoRegionMovesIsRefused) {
  Animation animation = Exact(Human37(), kG);
  AddRegion(&animation, "arm", 0, 30, {"r_shoulder"}).method = Method::kExact;
  AddForce(&animation, 11, 12,
           PushForce{{GroupOf(animation, "l_elbow"), Vec3::Zero()}, Vec3::UnitX()});
  const Error error = BakeError(animation);
  EXPECT_EQ(error.place, "forces[0]");
  EXPECT_NE(error.message.find("no region moves \"l_elbow\" in frame 11"), std::string::npos);
}

}  // namespace
}  // namespace hazumi::test
