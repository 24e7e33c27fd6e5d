// Constraints, whole bakes: motions in closed form, and what momentum and energy say.

#include <gtest/gtest.h>

#include <cmath>

#include "engine/dynamics/kinematics.h"
#include "tests/support/compare.h"
#include "tests/support/figures.h"
#include "tests/support/momentum.h"
#include "tests/unit/bake/constraint_cases.h"

namespace hazumi::test {
namespace {

// e(t) = (e0 + (v0 + w e0) t) exp(-w t), w = 6.638352 fps / N: whatever else pushes, of whatever
// point.
TEST(ConstraintBake, AGapClosesAsAskedFromRestAndMoving) {
  for (const Vec3& at : {Vec3(0.0, 0.0, 0.0), Vec3(0.3, 0.0, 0.02)}) {
    for (const Vec3& v0 : {Vec3(0.0, 0.0, 0.0), Vec3(1.0, -2.0, 0.5)}) {
      Animation animation = Flying(FreeRod(), kG);
      for (int i = 0; i < 3; ++i) SetRoot(&animation, static_cast<RootCurve>(i), 0.0, v0[i]);
      Constraint& latch = AddPoint(&animation, OnRoot(at), InWorld(Vec3(0.4, 0.1, -0.2)), 0, 30);
      latch.arrive_frames = 10;
      const Motion motion = BakeOrFail(animation);
      const Vec3 e0 = at - latch.b.offset;
      const double w = 6.638352067993813 * 30.0 / latch.arrive_frames;
      for (const MotionFrame& frame : motion.frames) {
        const double t = frame.frame / 30.0;
        const Vec3 expected = (e0 + t * (v0 + w * e0)) * std::exp(-w * t);
        const Vec3 gap = frame.X_WR * at - latch.b.offset;
        EXPECT_LT((gap - expected).norm(), 1e-7 * e0.norm()) << frame.frame;
        if (frame.frame == 10 && v0.isZero()) {
          EXPECT_NEAR(gap.norm() / e0.norm(), 0.01, 1e-7);
        }
      }
    }
  }
}

// A flying rod one end of which is held is the rod that turns about that end.
TEST(ConstraintBake, ARodHeldAtItsEndSwingsAsOnAHinge) {
  Animation animation = Flying(FreeRod(), kG);
  const Vec3 end(-0.5 * kLength, 0.0, 0.0);
  AddPoint(&animation, OnRoot(end), InWorld(end), 0, 30);
  const Motion motion = BakeOrFail(animation);
  Animation hinged = Exact(RodAbout(Vec3::UnitY()), kG);
  AddRegion(&hinged, "swing", 0, 30, {"pivot"}).method = Method::kExact;
  KeysOf(&hinged, "pivot") = {{0, 0.0, 0.0, kHold}};
  const Motion expected = BakeOrFail(hinged);
  for (const MotionFrame& frame : motion.frames) {
    const double angle = expected.frames[frame.frame].q[0];
    const Vec3 tip = Vec3(std::cos(angle) * kLength, 0.0, -std::sin(angle) * kLength) + end;
    EXPECT_LT((frame.X_WR * Vec3(-end) - tip).norm(), 1e-8) << frame.frame;
    EXPECT_LT((frame.X_WR * end - end).norm(), 1e-10) << frame.frame;
  }
  EXPECT_GT(std::abs(expected.frames[30].q[0]), 1.0);
}

// From level, the end of a rod is held with (5/2 m g sin q, 1/4 m g cos q): at rest with m g / 4.
TEST(ConstraintBake, TellsTheForceThatHoldsARodThatFallsFromLevel) {
  Animation animation = Flying(FreeRod(), kG);
  const Vec3 end(-0.5 * kLength, 0.0, 0.0);
  AddPoint(&animation, OnRoot(end), InWorld(end), 0, 30);
  const Motion motion = BakeOrFail(animation);
  for (const MotionFrame& frame : motion.frames) {
    if (frame.frame == 30) continue;
    const Vec3 along = frame.X_WR.R.col(0);
    EXPECT_NEAR(frame.constraint_forces.at(0), ForceOfFallingRod(-along.z()), 1e-5) << frame.frame;
  }
  EXPECT_NEAR(motion.frames[0].constraint_forces.at(0), RodInertiaShare() * kMass * kG, 1e-9);
}

// It breaks where its force reaches what it stands, and is gone.
TEST(ConstraintBake, BreaksUnderMoreThanItStands) {
  Animation animation = Flying(FreeRod(), kG);
  const Vec3 end(-0.5 * kLength, 0.0, 0.0);
  Constraint& pin = AddPoint(&animation, OnRoot(end), InWorld(end), 0, 30);
  const Motion whole = BakeOrFail(animation);
  pin.break_force = 1.9 * kMass * kG;
  const Motion motion = BakeOrFail(animation);
  const std::vector<MotionEvent> breaks = EventsOf(motion, EventKind::kBreak);
  ASSERT_EQ(breaks.size(), 1);
  EXPECT_EQ(breaks[0].joint, "held");
  const int after = static_cast<int>(std::ceil(breaks[0].time * 30.0));
  EXPECT_LE(whole.frames[after - 1].constraint_forces[0], *pin.break_force);
  EXPECT_GT(whole.frames[after].constraint_forces[0], *pin.break_force);
  EXPECT_EQ(motion.frames[after].constraint_forces.at(0), 0.0);
  EXPECT_LT((motion.frames[after - 1].X_WR.p - whole.frames[after - 1].X_WR.p).norm(), 1e-9);
  // From there on it flies: its centre falls freely, and it turns as it did.
  const MotionLimit& left = motion.frames[after].after;
  for (int i = after + 1; i <= 30; ++i) {
    const double t = (i - after) / 30.0;
    const Vec3 p = left.X_WR.p + t * left.root_v - 0.5 * kG * t * t * Vec3::UnitZ();
    EXPECT_LT((motion.frames[i].X_WR.p - p).norm(), 1e-9) << i;
    EXPECT_LT((motion.frames[i].before.root_w - left.root_w).norm(), 1e-9) << i;
  }
}

// A rod that flies across a latch which takes its end turns about it with 3 v / (2 L): and slower
// where it is no thin one.
TEST(ConstraintBake, WhatIsLeftOfItsSpeedIsAnInelasticImpulse) {
  Animation animation = Flying(FreeRod(), 0.0);
  SetRoot(&animation, kRootZ, 0.0, 4.0);
  const Vec3 end(-0.5 * kLength, 0.0, 0.0);
  AddPoint(&animation, OnRoot(end), InWorld(end), 0, 30);
  const Motion motion = BakeOrFail(animation);
  const double I = InertiaAboutEnd();
  const double w = kMass * 4.0 * 0.5 * kLength / I;
  for (int i = 1; i < 30; ++i) {
    EXPECT_NEAR(motion.frames[i].after.root_w.norm(), w, 1e-8) << i;
    EXPECT_LT((motion.frames[i].X_WR * end - end).norm(), 1e-10) << i;
  }
}

TEST(ConstraintBake, AnImpulseThatIsTooMuchBreaksItAndIsNotFelt) {
  Animation animation = Flying(FreeRod(), 0.0);
  SetRoot(&animation, kRootZ, 0.0, 4.0);
  const Vec3 end(-0.5 * kLength, 0.0, 0.0);
  Constraint& pin = AddPoint(&animation, OnRoot(end), InWorld(end), 0, 30);
  pin.break_impulse = 0.2;
  const Motion motion = BakeOrFail(animation);
  EXPECT_EQ(EventsOf(motion, EventKind::kBreak).size(), 1);
  EXPECT_NEAR(motion.frames[20].after.root_v.z(), 4.0, 1e-12);
  EXPECT_LT(motion.frames[20].after.root_w.norm(), 1e-12);
}

// Two that say the same share the force; the motion is that of one.
TEST(ConstraintBake, RedundantOnesShareTheForce) {
  Animation animation = Flying(FreeRod(), kG);
  const Vec3 end(-0.5 * kLength, 0.0, 0.0);
  AddPoint(&animation, OnRoot(end), InWorld(end), 0, 30);
  const Motion one = BakeOrFail(animation);
  AddPoint(&animation, OnRoot(end), InWorld(end), 0, 30);
  const Motion two = BakeOrFail(animation);
  for (int i = 0; i < 30; ++i) {
    EXPECT_LT((one.frames[i].X_WR.p - two.frames[i].X_WR.p).norm(), 1e-8) << i;
    const double f = one.frames[i].constraint_forces[0];
    EXPECT_NEAR(two.frames[i].constraint_forces[0], 0.5 * f, 1e-6 * f) << i;
    EXPECT_NEAR(two.frames[i].constraint_forces[1], 0.5 * f, 1e-6 * f) << i;
  }
}

TEST(ConstraintBake, RefusesAGapThatNothingCloses) {
  Animation animation = Flying(FreeRod(), kG);
  AddPoint(&animation, OnRoot(Vec3::Zero()), InWorld(Vec3(0.0, 0.0, 0.0123)), 0, 30);
  const Error error = BakeError(animation);
  EXPECT_EQ(error.place, "constraints[0]");
  EXPECT_NE(error.message.find("12.3 mm apart in frame 0"), std::string::npos) << error.message;
  EXPECT_NE(error.message.find("arrive_frames"), std::string::npos) << error.message;
}

// One point cannot be at two places.
TEST(ConstraintBake, RefusesWhatContradictsItself) {
  Animation animation = Flying(FreeRod(), kG);
  AddPoint(&animation, OnRoot(Vec3::Zero()), InWorld(Vec3(0.0, 0.0, 0.0)), 0, 30);
  AddPoint(&animation, OnRoot(Vec3::Zero()), InWorld(Vec3(0.0, 0.0, 9e-5)), 0, 30);
  const Error error = BakeError(animation);
  EXPECT_NE(error.message.find("cannot all be kept"), std::string::npos) << error.message;
}

// A string of a constant length to a point of the world: a pendulum again.
TEST(ConstraintBake, ADistanceIsKept) {
  Animation animation = Flying(FreeRod(), kG);
  SetRoot(&animation, kRootX, 0.5, 0.0);
  SetRoot(&animation, kRootY, 0.0, 1.0);
  Constraint& cord =
      AddPoint(&animation, OnRoot(Vec3(0.1, 0.0, 0.0)), InWorld(Vec3::Zero()), 0, 30);
  cord.kind = ConstraintKind::kDistance;
  cord.length = 0.6;
  const Motion motion = BakeOrFail(animation, {{}, nullptr, true});
  for (const MotionFrame& frame : motion.frames) {
    EXPECT_NEAR((frame.X_WR * cord.a.offset).norm(), 0.6, 1e-9) << frame.frame;
  }
  EXPECT_LT(std::abs(EnergyGained(animation, motion)), 1e-7);
}

// A welded rod hangs still, and turns with what it is welded to.
TEST(ConstraintBake, AWeldKeepsPlaceAndTurn) {
  Animation animation = Flying(FreeRod(), kG);
  Constraint& weld =
      AddPoint(&animation, OnRoot(Vec3(0.2, 0.0, 0.0)), InWorld(Vec3(0.2, 0.0, 0.0)), 0, 30);
  weld.kind = ConstraintKind::kWeld;
  const Motion motion = BakeOrFail(animation);
  for (const MotionFrame& frame : motion.frames) {
    EXPECT_LT(frame.X_WR.p.norm(), 1e-10) << frame.frame;
    EXPECT_LT((frame.X_WR.R - Mat3::Identity()).norm(), 1e-10) << frame.frame;
  }
}

// A weld that is turned by a quarter closes that too, as its law says.
TEST(ConstraintBake, AWeldTurnsWhatItHolds) {
  Animation animation = Flying(FreeRod(), kG);
  Constraint& weld =
      AddPoint(&animation, OnRoot(Vec3::Zero()), InWorld(Vec3(0.1, 0.0, 0.1)), 0, 30);
  weld.kind = ConstraintKind::kWeld;
  weld.arrive_frames = 12;
  weld.b.rotation = AxisRotation<double>(Vec3::UnitZ(), std::sin(1.2), std::cos(1.2));
  const Motion motion = BakeOrFail(animation);
  const double w = 6.638352067993813 * 30.0 / weld.arrive_frames;
  for (const MotionFrame& frame : motion.frames) {
    const double t = frame.frame / 30.0, left = 1.2 * (1.0 + w * t) * std::exp(-w * t);
    const Mat3 turn = frame.X_WR.R * weld.b.rotation.transpose();
    EXPECT_NEAR(Eigen::AngleAxisd(turn).angle(), left, 1e-7) << frame.frame;
  }
}

// Both hands of a pinned figure on a bar, all of both arms loose: nothing parts, nothing is lost.
TEST(ConstraintBake, BothHandsOnABarStayThereForTenSeconds) {
  Animation animation = HandsOnBar();
  animation.last_frame = 300;
  for (DynamicsRegion& region : animation.regions) region.last_frame = 300;
  for (Constraint& grip : animation.constraints) grip.last_frame = 300;
  const Motion motion = BakeOrFail(animation, {{}, nullptr, true});
  Worst gap("gap_log10_m");
  for (const MotionFrame& frame : motion.frames) {
    for (const Constraint& grip : animation.constraints) {
      EXPECT_LE(gap(GapAt(animation, grip, frame)), 1e-7) << frame.frame;
    }
  }
  const EnergyBalance energy = motion.regions[0].energy.value();
  EXPECT_LT(std::abs(energy.residual()), 1e-7);
  EXPECT_NEAR(energy.WorkOf("constraints"), 0.0, 1e-7);
}

// The hand that is held by the other one, which keys move, goes along.
TEST(ConstraintBake, AHandFollowsTheOneThatHoldsIt) {
  Animation animation = Exact(Human37(), kG);
  AddRegion(&animation, "arm", 0, 30, {"l_shoulder"}, 0.9).method = Method::kExact;
  KeysOf(&animation, "r_shoulder_y") = {{0, -0.2, {}}, {15, -0.9, {}}, {30, -0.3, {}}};
  KeysOf(&animation, "r_shoulder_x") = {{0, 0.5, {}}};
  KeysOf(&animation, "r_elbow_y") = {{0, -1.5, {}}, {30, -1.8, {}}};
  Constraint& clasp =
      AddPoint(&animation, OnJoint(animation, "l_wrist"), OnJoint(animation, "r_wrist"), 0, 30);
  clasp.arrive_frames = 8;
  const Motion motion = BakeOrFail(animation, {{}, nullptr, true});
  const double before = GapAt(animation, clasp, motion.frames[0]);
  EXPECT_GT(before, 0.2);
  // Straight at first, it has no hold to be drawn in by, and is late.
  EXPECT_LT(GapAt(animation, clasp, motion.frames[12]), 0.02 * before);
  // Where a limit holds its wrist a little of the pull is held back.
  for (int i = 24; i <= 30; ++i) EXPECT_LT(GapAt(animation, clasp, motion.frames[i]), 5e-4) << i;
  EXPECT_LT(std::abs(motion.regions[0].energy->residual()), 1e-6);
  EXPECT_GT(std::abs(motion.regions[0].energy->WorkOf("constraints")), 0.1);
}

// Two arms, each a region, that hold each other's wrists are one island; what goes on between them
// changes no momentum of a figure in flight.
TEST(ConstraintBake, HandsThatHoldEachOtherInFlightChangeNoMomentum) {
  Animation animation = Exact(Human37(), kG);
  SetRoot(&animation, kRootZ, 5.0, 2.0);
  AddGravity(&animation, 0, 30);
  AddRegion(&animation, "left", 0, 30, {"l_shoulder"}, 0.95).method = Method::kExact;
  AddRegion(&animation, "right", 0, 30, {"r_shoulder"}, 0.95).method = Method::kExact;
  DynamicsRegion& root = AddRegion(&animation, "root", 0, 30, {});
  root.root = true;
  root.method = Method::kExact;
  KeysOf(&animation, "r_shoulder_y") = {{0, -0.2, -3.0, {}}, {30, -0.3, {}}};
  AddPoint(&animation, OnJoint(animation, "l_wrist"), OnJoint(animation, "r_wrist"), 0, 30)
      .arrive_frames = 10;
  const Motion motion = BakeOrFail(animation);
  const Momentum start = MomentumOf(*animation.figure, motion.frames[0].after);
  for (int i = 1; i <= 30; ++i) {
    const double t = i / 30.0;
    const Momentum now = MomentumOf(*animation.figure, motion.frames[i].before);
    EXPECT_LT((now.L - start.L).norm(), 1e-7) << i;
    const Vec3 com = start.com + t * start.com_v - 0.5 * kG * t * t * Vec3::UnitZ();
    EXPECT_LT((now.com - com).norm(), 1e-8) << i;
  }
}

// What is tied does not go through the limits of its joints, and the account closes over impacts.
TEST(ConstraintBake, LimitsHoldBesideConstraints) {
  Animation animation = Chain();
  ConstraintEnd tip = OnJoint(animation, "three");
  tip.offset = 0.4 * Vec3::UnitX();
  AddPoint(&animation, tip, InWorld(Vec3(0.95, 0.0, 0.5)), 0, 30).arrive_frames = 6;
  const Motion motion = BakeOrFail(animation, {{}, nullptr, true});
  EXPECT_FALSE(EventsOf(motion, EventKind::kLimit).empty());
  for (const MotionFrame& frame : motion.frames) {
    for (int j = 0; j < frame.q.size(); ++j) EXPECT_LE(std::abs(frame.q[j]), 0.6 + 1e-8);
  }
  EXPECT_LT(GapAt(animation, animation.constraints[0], motion.frames[20]), 1e-4);
  EXPECT_LT(std::abs(motion.regions[0].energy->residual()), 1e-6);
}

// Its tip held where it is, a chain sags between its ends until its limits, which then press.
TEST(ConstraintBake, AChainBetweenTwoEndsSagsToItsLimits) {
  Animation animation = Chain();
  for (const char* joint : {"one", "two", "three"}) {
    KeysOf(&animation, joint) = {{0, joint[1] == 'n' ? -0.5 : 0.5, {}}};
  }
  animation.last_frame = animation.regions[0].last_frame = 90;
  Animation bare = animation;
  bare.last_frame = 1;
  ConstraintEnd tip = OnJoint(animation, "three");
  tip.offset = 0.4 * Vec3::UnitX();
  Constraint held;
  held.a = tip;
  held.b = InWorld(Vec3::Zero());
  const Motion still = BakeOrFail(bare);
  DynamicsWorkspace ws(*animation.figure);
  ComputePositions(*animation.figure, still.frames[0].X_WR, still.frames[0].q, &ws);
  const BodyScratch& body = ws.body(JointIndex(2));
  AddPoint(&animation, tip, InWorld(body.p + body.R * tip.offset), 0, 90);
  const Motion motion = BakeOrFail(animation, {{}, nullptr, true});
  for (const MotionFrame& frame : motion.frames) {
    EXPECT_LE(GapAt(animation, animation.constraints[0], frame), 1e-7) << frame.frame;
    for (int j = 0; j < frame.q.size(); ++j) EXPECT_LE(std::abs(frame.q[j]), 0.6 + 1e-8);
  }
  EXPECT_FALSE(EventsOf(motion, EventKind::kLimit).empty());
  EXPECT_LT(std::abs(motion.regions[0].energy->residual()), 1e-6);
}

// At full reach a constraint tells nothing of how a chain sags. That is said, with the constraint.
TEST(ConstraintBake, TellsOfALimbThatIsStraight) {
  Animation animation = Chain();
  ConstraintEnd tip = OnJoint(animation, "three");
  tip.offset = 0.4 * Vec3::UnitX();
  AddPoint(&animation, tip, InWorld(Vec3(1.2, 0.0, 0.0)), 0, 30);
  const Error error = BakeError(animation);
  EXPECT_NE(error.message.find("constraint \"held\" has no hold"), std::string::npos)
      << error.message;
  EXPECT_NE(error.message.find("straight"), std::string::npos) << error.message;
}

// Edited and baked on: the same bits as baked anew.
TEST(ConstraintBake, AfterAnEditIsTheSameBits) {
  Animation animation = HandsOnBar();
  animation.solver.tolerance = 0.01 * kDegree;
  animation.constraints[1].first_frame = 6;
  animation.constraints[1].arrive_frames = 6;
  animation.constraints[0].break_force = 60.0;
  KeysOf(&animation, "neck_y") = {{0, 0.1, {}}, {12, 0.3, {}}, {30, 0.2, {}}};
  IncrementalBake bake(animation);
  ExpectBakedAsAnew(&bake, animation);
  KeysOf(&animation, "neck_y")[1].value = 0.25;
  bake.Update(animation);
  ExpectBakedAsAnew(&bake, animation);
  animation.regions[0].friction[0] = 0.7;
  bake.Update(animation);
  ExpectBakedAsAnew(&bake, animation);
  animation.constraints[1].b.offset.z() += 0.02;
  bake.Update(animation);
  ExpectBakedAsAnew(&bake, animation);
}

}  // namespace
}  // namespace hazumi::test
