// What tumbles to rest on many points, where contacts come too fast to be followed.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/bake/constraint_cases.h"
#include "tests/unit/bake/contact_cases.h"
#include "tests/unit/bake/loose_human.h"

namespace hazumi::test {
namespace {

constexpr double kMostDepth = 5e-4;  // [m]

double DeepestOf(const Animation& animation, const Motion& motion) {
  double depth = 0.0;
  for (const MotionFrame& frame : motion.frames) {
    depth = std::max(depth, -ClearanceOf(animation, frame));
  }
  return depth;
}

void ExpectAtRest(const Animation& animation, const Motion& motion) {
  double most = 0.0;
  for (const MotionFrame& frame : motion.frames) {
    most = std::max(most, MomentumOf(*animation.figure, frame.after).kinetic);
  }
  EXPECT_LT(MomentumOf(*animation.figure, motion.frames.back().after).kinetic, 1e-6 * most);
}

TEST(TumbleBake, AHumanFallsOnAPlaneAndLiesStill) {
  Animation animation = LooseHuman(120, 1.4, 1.0);
  BakeOptions options;
  options.energy = true;
  const Motion motion = BakeOrFail(animation, options);
  EXPECT_LT(DeepestOf(animation, motion), kMostDepth);
  ExpectAtRest(animation, motion);
  const EnergyBalance& energy = motion.regions[0].energy.value();
  EXPECT_NEAR(energy.residual(), 0.0, 1e-6 * std::abs(energy.potential_start));
  EXPECT_LT(energy.WorkOf("contact"), 0.0);
}

// Up to the first contacts the error is known; then it is not, and the report says so.
TEST(TumbleBake, TheReportSaysUpToWhereTheErrorIsEstimated) {
  Animation animation = LooseHuman(60, 1.4, 1.0);
  const RegionReport human = BakeOrFail(animation).regions[0];
  ASSERT_TRUE(human.estimated_until.has_value());
  EXPECT_GT(*human.estimated_until, 5.0);
  EXPECT_LT(*human.estimated_until, 20.0);
  EXPECT_LE(human.error_estimate, human.tolerance);

  Animation ball = Loose(FreeCapsule(0.0, kBallRadius), 60);
  AddFloor(&ball);
  SetRootAt(&ball, Vec3(0.0, 0.0, 1.0));
  EXPECT_FALSE(BakeOrFail(ball).regions[0].estimated_until.has_value());
}

TEST(TumbleBake, AChainFallsAcrossABoxesEdges) {
  for (const double x : {-0.6, -0.3, 0.0, 0.2, 0.5}) {
    Animation animation = Loose(*Chain().figure, 150, {"one"});
    animation.regions[0].friction.assign(animation.regions[0].joints.size(), 0.8);
    AddFloor(&animation);
    SceneObject box;
    box.name = "box";
    box.shape = Box{{Mat3::Identity(), Vec3(x, 0.05, 0.2)}, Vec3(0.3, 0.2, 0.2)};
    animation.scene.push_back(box);
    SetRootAt(&animation, Vec3(0.0, 0.0, 0.8));
    const Motion motion = BakeOrFail(animation);
    EXPECT_LT(DeepestOf(animation, motion), kMostDepth) << x;
    ExpectAtRest(animation, motion);
  }
}

TEST(TumbleBake, WhatBeginsInsideComesOutSlowlyAndIsWarnedOf) {
  constexpr double kDepth = 0.005, kWayOut = 0.1;  // [m, m/s]
  Animation animation = Loose(FreeRod(), 60);
  AddFloor(&animation);
  SetRootAt(&animation, Vec3(0.0, 0.0, 0.5 * kThickness - kDepth));
  const Motion motion = BakeOrFail(animation);
  ASSERT_EQ(motion.warnings.size(), 1u);
  EXPECT_EQ(motion.warnings[0].place, "regions[0]");
  EXPECT_EQ(motion.warnings[0].message,
            "\"rod\" begins 5 mm inside \"floor\" in frame 0: it is pushed out slowly; move it out "
            "in that frame");
  for (const MotionFrame& frame : motion.frames) {
    EXPECT_GT(ClearanceOf(animation, frame), -kDepth - 1e-4) << frame.frame;
    EXPECT_LT(frame.after.root_v.norm(), kWayOut) << frame.frame;
  }
  EXPECT_NEAR(ClearanceOf(animation, motion.frames.back()), 0.0, 1e-4);
}

// The force of a hold at each frame [N]; 0 where it is broken.
std::vector<double> ForcesOf(const Motion& motion) {
  std::vector<double> forces;
  for (const MotionFrame& frame : motion.frames) forces.push_back(frame.constraint_forces.at(0));
  return forces;
}

// A hand that holds on to the hip is torn off as the fall is broken by the ground, in time-stepping
// mode.
TEST(TumbleBake, AHoldBreaksWhereItsForceIsMoreThanItStands) {
  Animation animation = LooseHuman(40, 1.4, 1.0);
  Animation bare = animation;
  bare.regions.clear();
  bare.placements.clear();
  const MotionFrame start = BakeOrFail(bare).frames[0];
  DynamicsWorkspace ws(*animation.figure);
  ComputePositions(*animation.figure, start.X_WR, start.q, &ws);
  const ConstraintEnd hand = OnJoint(animation, "r_wrist");
  const BodyScratch& body = ws.body(animation.figure->group(*hand.joint).last());
  Constraint& hold = AddPoint(&animation, hand, OnRoot(start.X_WR.Inverse() * Vec3(body.p)), 0, 40);
  const Motion whole = BakeOrFail(animation);
  const std::vector<double> forces = ForcesOf(whole);
  const double frozen = whole.regions[0].estimated_until.value();
  const auto first = forces.begin() + static_cast<std::ptrdiff_t>(std::ceil(frozen));
  const auto strongest = std::max_element(first, forces.end());
  const double before = *std::max_element(forces.begin(), first);
  ASSERT_GT(*strongest, 2.0 * before);
  hold.break_force = 0.5 * (*strongest + before);
  const Motion motion = BakeOrFail(animation);
  const std::vector<MotionEvent> breaks = EventsOf(motion, EventKind::kBreak);
  ASSERT_EQ(breaks.size(), 1u);
  EXPECT_GE(30.0 * breaks[0].time, frozen);
  EXPECT_LE(30.0 * breaks[0].time, static_cast<double>(strongest - forces.begin()));
  for (const double force : ForcesOf(motion)) EXPECT_LE(force, *hold.break_force);
}

// Two boxes hold a rod from both sides: there is nowhere to go, and nothing moves much.
TEST(TumbleBake, WhereThereIsNoRoomForcesStayFinite) {
  Animation animation = Loose(FreeRod(), 30);
  for (const double side : {-1.0, 1.0}) {
    SceneObject plate;
    plate.name = side < 0.0 ? "below" : "above";
    plate.shape = Box{{Mat3::Identity(), Vec3(0.0, 0.0, 0.5 + side * 0.12)}, Vec3(1.0, 1.0, 0.1)};
    animation.scene.push_back(plate);
  }
  SetRootAt(&animation, Vec3(0.0, 0.0, 0.5));
  const Motion motion = BakeOrFail(animation);
  for (const MotionFrame& frame : motion.frames) {
    EXPECT_NEAR(frame.X_WR.p.z(), 0.5, 0.02) << frame.frame;
    EXPECT_LT(frame.after.root_v.norm(), 0.1) << frame.frame;
  }
}

// Ground far below changes nothing but the way it is solved.
TEST(TumbleBake, WhatTouchesNothingMovesAsIfNothingCouldBeTouched) {
  Animation animation = LooseHuman(15, 20.0, 0.3);
  for (size_t j = 0; j < animation.joint_keys.size(); ++j) {
    animation.joint_keys[j] = {{0, 0.0, 1.0 + 0.1 * static_cast<double>(j % 7), kCubic}};
  }
  animation.root_keys[3] = {{0, 0.0, 3.0, kCubic}};
  animation.solver.tolerance = 1e-4 * kDegree;
  const Motion touching = BakeOrFail(animation);
  animation.regions[0].touches_scene = false;
  const Motion free = BakeOrFail(animation);
  for (size_t f = 0; f < free.frames.size(); ++f) {
    EXPECT_LT((touching.frames[f].q - free.frames[f].q).cwiseAbs().maxCoeff(), 1e-5) << f;
    EXPECT_LT((touching.frames[f].X_WR.p - free.frames[f].X_WR.p).norm(), 1e-5) << f;
  }
}

}  // namespace
}  // namespace hazumi::test
