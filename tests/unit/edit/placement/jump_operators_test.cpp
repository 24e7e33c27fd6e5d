// A jump that is keyed from where the figure stands onto a spot.

#include <algorithm>
#include <cmath>

#include "engine/bake/bake.h"
#include "engine/placement/contact.h"
#include "tests/unit/edit/placement/jumps.h"

namespace hazumi::test {
namespace {

using edit::Session;

TEST(JumpOperators, AJumpLandsWithItsToesOnTheSpotOnABox) {
  Session session;
  AddBox(&session);
  Do(&session, "jump.add", {{"x", 1.15}, {"y", 0.1}});
  const Motion motion = JumpMotion(&session);
  const JumpPhases phases = PhasesOf(session);
  const Vec3 toes = ToesIn(motion.frames[phases.landing], &session);
  EXPECT_LE((toes.head<2>() - Eigen::Vector2d(1.15, 0.1)).norm(), 1e-3);
  EXPECT_NEAR(toes.z(), kHigh, 0.05);
  const Vec3 at_end = ToesIn(motion.frames[phases.end], &session);
  EXPECT_LE((at_end - toes).norm(), 0.01);
  EXPECT_TRUE(motion.warnings.empty());
}

TEST(JumpOperators, ItFliesFreelyAndTouchesNothingOnTheWay) {
  Session session;
  AddBox(&session);
  Do(&session, "jump.add", {{"x", 1.15}, {"y", 0.0}});
  const Motion motion = JumpMotion(&session);
  const JumpPhases phases = PhasesOf(session);
  constexpr double kFrame = 1.0 / 30.0;
  for (int f = phases.take_off + 4; f < phases.landing; ++f) {
    const auto com = [&](int i) { return motion.frames[i].com; };
    const Vec3 fall = (com(f) - 2.0 * com(f - 1) + com(f - 2)) / (kFrame * kFrame);
    EXPECT_LE((fall - Vec3(0.0, 0.0, -9.81)).norm(), 1e-6) << f;
    const DynamicsWorkspace ws = Placed(motion.frames[f], &session);
    EXPECT_GT(Clearance(session.figure(), session.animation()->scene, ws), 0.0) << f;
  }
}

TEST(JumpOperators, NothingIsDeeperInGroundOrBoxThanThreeMillimetres) {
  Session session;
  AddBox(&session);
  Do(&session, "jump.add", {{"x", 1.15}, {"y", 0.0}});
  const Motion motion = JumpMotion(&session);
  double deepest = 0.0;
  for (const MotionFrame& frame : motion.frames) {
    const DynamicsWorkspace ws = Placed(frame, &session);
    deepest = std::min(deepest, Clearance(session.figure(), session.animation()->scene, ws));
  }
  EXPECT_GE(deepest, -0.003);
}

TEST(JumpOperators, ItRisesAsHighAsItIsTold) {
  for (const double height : {0.2, 0.4, 0.8}) {
    Session session;
    Do(&session, "jump.add", {{"x", 0.5}, {"height", height}});
    const Motion motion = JumpMotion(&session);
    const JumpPhases phases = PhasesOf(session);
    double highest = 0.0;
    for (const MotionFrame& frame : motion.frames) highest = std::max(highest, frame.com.z());
    // The flight takes whole frames, which makes it a little higher or lower.
    EXPECT_NEAR(highest - motion.frames[phases.take_off].com.z(), height, 0.06) << height;
  }
}

Vec3 Step(const Motion& motion, int frame) {
  return motion.frames[frame].com - motion.frames[frame - 1].com;
}

TEST(JumpOperators, AsTheFeetTouchItSinksOnAndOnlySlows) {
  for (const double height : {0.2, 0.35, 0.5, 0.8}) {
    Session session;
    Do(&session, "jump.add", {{"x", 0.6}, {"height", height}});
    const Motion motion = JumpMotion(&session);
    const auto sunk = [&](int f) { return -Step(motion, f).z(); };
    const int landing = PhasesOf(session).landing;
    EXPECT_NEAR(sunk(landing + 1), sunk(landing), 0.15 * sunk(landing)) << height;
    for (int f = landing + 1; sunk(f) > 0.002; ++f) {
      EXPECT_LE(sunk(f + 1), 1.05 * sunk(f)) << height << ", frame " << f - landing;
    }
  }
}

// Its centre of mass, from one frame to the next: a leap in that is seen as a hitch. To the front,
// up, back, onto a box.
TEST(JumpOperators, NowhereDoesItSpeedUpOrStopAtOnce) {
  constexpr double kMost = 0.045;  // [m] a frame more or less than in the one before it
  for (const double x : {0.05, 0.6, 1.15, -0.3}) {
    for (const double height : {0.2, 0.35, 0.5}) {
      Session session;
      if (x == 1.15) AddBox(&session);
      if (x == 1.15 && height < 0.5) continue;
      Do(&session, "jump.add", {{"x", x}, {"height", height}});
      const Motion motion = JumpMotion(&session);
      for (int f = 2; f <= PhasesOf(session).end; ++f) {
        EXPECT_LE((Step(motion, f) - Step(motion, f - 1)).norm(), kMost)
            << x << ", " << height << ", frame " << f << " of " << PhasesOf(session).landing;
      }
    }
  }
}

TEST(JumpOperators, ItEndsStandingAsItBegan) {
  Session session;
  Do(&session, "pose.rotate", {{"joint", "neck_rotation"}, {"to", 30}});
  Do(&session, "jump.add");
  const Motion motion = JumpMotion(&session);
  const JumpPhases phases = PhasesOf(session);
  EXPECT_LE((motion.frames[phases.end].q - motion.frames[0].q).cwiseAbs().maxCoeff(), 1e-9);
  const Vec3 way = motion.frames[phases.end].X_WR.p - motion.frames[0].X_WR.p;
  EXPECT_LE((way - Vec3(way.x(), 0.0, 0.0)).norm(), 0.01);
  EXPECT_GT(way.x(), 0.5);
}

TEST(JumpOperators, TheBakeTellsTakeOffApexAndLandingOnceEachInTheirFrames) {
  for (const double x : {0.4, 0.8, 1.15}) {
    Session session;
    if (x == 1.15) AddBox(&session);
    Do(&session, "jump.add", {{"x", x}});
    const JumpPhases phases = PhasesOf(session);
    // As edits left the motion, and baked from nothing.
    const Motion whole = Bake(*session.animation()).value();
    for (const Motion& motion : {JumpMotion(&session), whole}) {
      std::vector<MotionEvent> told;
      for (const MotionEvent& event : motion.events) {
        if (event.kind != EventKind::kPinChange) told.push_back(event);
      }
      ASSERT_EQ(told.size(), 3u) << x;
      EXPECT_EQ(told[0].kind, EventKind::kTakeOff);
      EXPECT_EQ(told[0].frame, phases.take_off);
      EXPECT_EQ(told[0].joint, "r_toe");
      EXPECT_EQ(told[1].kind, EventKind::kApex);
      EXPECT_GT(told[1].frame, phases.take_off);
      EXPECT_LT(told[1].frame, phases.landing);
      EXPECT_EQ(told[2].kind, EventKind::kLanding);
      EXPECT_EQ(told[2].frame, phases.landing);
    }
  }
}

TEST(JumpOperators, TheTimelineIsMadeLongEnoughAndOneUndoTakesAllOfItBack) {
  Session session;
  Do(&session, "time.range", {{"first", 0}, {"last", 10}});
  const Project before = session.project();
  Do(&session, "jump.add");
  EXPECT_EQ(session.project().frames.last, PhasesOf(session).end);
  Do(&session, "edit.undo");
  EXPECT_TRUE(session.project() == before);
}

TEST(JumpOperators, SayWhatTheyRefuse) {
  Session session;
  AddBox(&session);
  const auto refused = [&](const edit::Json& given) {
    return Refused(&session, "jump.add", given).ToString();
  };
  EXPECT_EQ(refused({{"x", 1.15}, {"height", 0.2}}),
            "jump.add.height: it lands 33 cm higher than it takes off: give a greater height");
  EXPECT_NE(refused({{"x", 1.15}, {"height", 0.36}}).find("meets \"box\""), std::string::npos);
  ASSERT_EQ(session.project().placements.size(), 0u);
  Do(&session, "region.add", {{"first", 2}, {"last", 8}, {"joints", {"r_shoulder+"}}});
  EXPECT_EQ(
      refused({{"x", 0.5}}),
      "jump.add: the region \"region\" moves joints in frames 2 to 8; jump before or after it");
  Do(&session, "edit.undo");
  Do(&session, "scene.gravity", {{"gravity", 0}});
  EXPECT_EQ(refused({{"x", 0.5}}), "jump.add.height: without gravity nothing comes down again");
}

}  // namespace
}  // namespace hazumi::test
