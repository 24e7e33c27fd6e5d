// A whole throw that is made of what a hand holds: where the ball comes down, and how the figure
// moves.

#include <optional>

#include "engine/dynamics/kinematics.h"
#include "engine/placement/contact.h"
#include "tests/unit/edit/held/throws.h"

namespace hazumi::test {
namespace {

using edit::Json;
using edit::Session;

TEST(AddThrow, TheBallComesDownOnTheSpotAndLiesThere) {
  for (const Vec3& spot : {Vec3(1.5, -0.4, 0.0), Vec3(3.0, 0.8, 0.0), Vec3(1.8, -1.5, 0.5)}) {
    Session session;
    AddBall(&session);
    const Project before = session.project();
    Do(&session, "throw.add", Onto(spot));
    const Vec3 lies = spot + Vec3(0.0, 0.0, 0.037);
    const Motion& motion = ThrowMotion(&session);
    EXPECT_LE((LandsAt(motion, ReleaseOf(session), lies.z()) - lies).norm(), 0.006);
    EXPECT_LE((motion.frames.back().objects[0].X_WO.p - lies).norm(), 1e-9);
    Do(&session, "edit.undo");
    EXPECT_EQ(session.project(), before);
  }
}

TEST(AddThrow, NothingSlidesJumpsOrStopsDeadAndItEndsAsItBegan) {
  Session session;
  AddBall(&session);
  Do(&session, "throw.add", Onto(Vec3(2.2, 0.0, 0.0)));
  const Motion& motion = ThrowMotion(&session);
  EXPECT_TRUE(motion.warnings.empty()) << motion.warnings[0].message;
  const Figure& figure = session.figure();
  DynamicsWorkspace ws(figure);
  const auto toe = [&](const MotionFrame& frame, const char* name) {
    ComputePositions(figure, frame.X_WR, frame.q, &ws);
    return ws.body(figure.group(*figure.FindGroup(name)).first).p;
  };
  for (const char* name : {"r_toe", "l_toe"}) {
    const Vec3 first = toe(motion.frames[0], name);
    for (const MotionFrame& frame : motion.frames) {
      EXPECT_LE((toe(frame, name) - first).norm(), 0.01) << name << " " << frame.frame;
    }
  }
  EXPECT_LE((motion.frames.back().q - motion.frames.front().q).lpNorm<Eigen::Infinity>(), 1e-9);
  EXPECT_LE((motion.frames.back().X_WR.p - motion.frames.front().X_WR.p).norm(), 1e-6);
}

TEST(AddThrow, TheFeetStayOnTheFloorInEveryFrame) {
  constexpr double kDeep = 0.001;  // [m]
  for (const char* hand : {"r_wrist", "l_wrist"}) {
    for (const Vec3& spot :
         {Vec3(1.5, -0.4, 0.0), Vec3(2.2, 0.0, 0.0), Vec3(3.0, 0.8, 0.0), Vec3(4.5, 0.0, 0.0)}) {
      Session session;
      Do(&session, "held.add_ball", {{"joint", hand}});
      Do(&session, "throw.add", Onto(spot));
      DynamicsWorkspace ws(session.figure());
      for (const MotionFrame& frame : ThrowMotion(&session).frames) {
        ComputePositions(session.figure(), frame.X_WR, frame.q, &ws);
        EXPECT_GE(Clearance(session.figure(), session.animation()->scene, ws), -kDeep)
            << hand << ", " << spot.x() << " m ahead, frame " << frame.frame;
      }
    }
  }
}

TEST(AddThrow, WhatCameDownIsSeenLyingForHalfASecond) {
  for (const int fps : {24, 30, 60}) {
    for (const double x : {1.5, 3.0, 4.5}) {
      Session session;
      AddBall(&session);
      Do(&session, "time.rate", {{"num", fps}});
      Do(&session, "throw.add", Onto(Vec3(x, 0.2, 0.0)));
      EXPECT_GE(session.project().frames.last, DownAt(session) + fps / 2) << fps << ", " << x;
    }
  }
}

// The arm swings forward, and no joint turns farther than it can.
TEST(AddThrow, TheArmSwingsForwardWithinItsLimits) {
  Session session;
  AddBall(&session);
  Do(&session, "throw.add", Onto(Vec3(2.2, 0.0, 0.0)));
  const Motion& motion = ThrowMotion(&session);
  const Figure& figure = session.figure();
  const JointIndex shoulder = *figure.FindJoint("r_shoulder_flexion");
  const ProjectRegion& region = session.project().regions[0];
  for (int frame = region.first_frame; frame < ReleaseOf(session); ++frame) {
    EXPECT_LT(motion.frames[frame].q[shoulder.value()],
              motion.frames[frame + 1].q[shoulder.value()]);
  }
  for (const MotionFrame& frame : motion.frames) {
    for (int j = 0; j < figure.num_joints(); ++j) {
      const Joint& joint = figure.joint(JointIndex(j));
      EXPECT_LE(frame.q[j], joint.upper + 0.01) << joint.name << " " << frame.frame;
      EXPECT_GE(frame.q[j], joint.lower - 0.01) << joint.name << " " << frame.frame;
    }
  }
}

TEST(AddThrow, TheLeftHandThrowsAsTheRightOneDoes) {
  Session right, left;
  AddBall(&right);
  Do(&left, "held.add_ball", {{"joint", "l_wrist"}});
  Do(&right, "throw.add", Onto(Vec3(2.2, -0.4, 0.0)));
  Do(&left, "throw.add", Onto(Vec3(2.2, 0.4, 0.0)));
  EXPECT_EQ(ReleaseOf(right), ReleaseOf(left));
  for (size_t i = 0; i < ThrowMotion(&right).frames.size(); ++i) {
    const Vec3 p = ThrowMotion(&right).frames[i].objects[0].X_WO.p;
    const Vec3 mirrored(p.x(), -p.y(), p.z());
    EXPECT_LE((ThrowMotion(&left).frames[i].objects[0].X_WO.p - mirrored).norm(), 0.01) << i;
  }
}

TEST(AddThrow, AFigureThatOnlyStandsIsTurnedToTheSpot) {
  for (const Vec3& spot : {Vec3(0.2, 2.0, 0.0), Vec3(-1.5, -1.0, 0.0)}) {
    Session session;
    AddBall(&session);
    Do(&session, "throw.add", Onto(spot));
    const Motion& motion = ThrowMotion(&session);
    const Vec3 ahead = motion.frames[0].X_WR.R * Vec3::UnitX();
    EXPECT_GT(ahead.dot(spot.normalized()), 0.99);
    EXPECT_LE((motion.frames.back().objects[0].X_WO.p - spot).head<2>().norm(), 1e-6);
  }
}

TEST(AddThrow, ItGoesOverABoxAndCanBeAimedElsewhereAfterwards) {
  Session session;
  AddBall(&session);
  Do(&session, "object.add_box",
     {{"name", "box"}, {"x", 1.3}, {"z", 0.4}, {"size_x", 0.4}, {"size_y", 1}, {"size_z", 0.8}});
  for (const char* id : {"throw.add", "held.throw_onto"}) {
    const Vec3 spot(id == std::string("throw.add") ? 2.2 : 2.6, 0.2, 0.0);
    Do(&session, id, Onto(spot));
    const Motion& motion = ThrowMotion(&session);
    for (const MotionFrame& frame : motion.frames) {
      const Vec3 p = frame.objects[0].X_WO.p;
      EXPECT_FALSE(std::abs(p.x() - 1.3) < 0.23 && p.z() < 0.83) << id << " " << frame.frame;
    }
    EXPECT_LE((motion.frames.back().objects[0].X_WO.p - spot).head<2>().norm(), 1e-6);
  }
  EXPECT_EQ(session.project().regions.size(), 1u);
}

// By how it was made at first the second throw is neither helped nor held back.
TEST(AddThrow, AimedAnewItIsTheThrowThatIsMadeThereAtOnce) {
  struct Case {
    Vec3 spot;
    std::optional<double> height;
  };
  for (const Case& wanted : {Case{{3.0, 0.8, 0.0}, {}}, Case{{1.5, 0.0, 0.0}, 1.0},
                             Case{{3.0, -0.5, 0.0}, 2.0}, Case{{2.2, 0.2, 0.0}, 0.3}}) {
    Json onto = Onto(wanted.spot);
    if (wanted.height) onto["height"] = *wanted.height;
    Session again, at_once;
    AddBall(&again);
    AddBall(&at_once);
    Do(&again, "throw.add", Onto(Vec3(2.0, -0.2, 0.0)));
    Do(&again, "held.throw_onto", onto);
    Do(&at_once, "throw.add", onto);
    EXPECT_EQ(ReleaseOf(again), ReleaseOf(at_once)) << wanted.spot.transpose();
    for (size_t i = 0; i < ThrowMotion(&at_once).frames.size(); ++i) {
      const auto ball = [&](Session* session) {
        return ThrowMotion(session).frames[i].objects[0].X_WO.p;
      };
      EXPECT_LE((ball(&again) - ball(&at_once)).norm(), 0.02)
          << wanted.spot.transpose() << " " << wanted.height.value_or(0) << " frame " << i;
    }
  }
}

TEST(AddThrow, SaysWhatItRefuses) {
  Session session;
  AddBall(&session);
  const auto refused = [&](const Vec3& spot) {
    return Refused(&session, "throw.add", Onto(spot)).ToString();
  };
  // It walks, and is not turned.
  Do(&session, "key.set", {{"curve", "root.x"}, {"frame", 0}, {"value", 0}});
  Do(&session, "key.set", {{"curve", "root.x"}, {"frame", 10}, {"value", 0.5}});
  EXPECT_EQ(refused(Vec3(-2.0, -0.2, 0.0)),
            "throw.add.x: the spot is 180 degrees to the side of where the figure faces; turn the "
            "figure to it");
  Do(&session, "held.set", {{"object", "ball"}, {"joint", "r_elbow"}});
  EXPECT_EQ(refused(Vec3(2.0, 0.0, 0.0)),
            "throw.add.object: \"r_elbow\" has \"ball\" in this frame: a throw is made of what a "
            "hand has (r_wrist or l_wrist)");
  Do(&session, "held.set", {{"object", "ball"}, {"joint", "r_wrist"}, {"release", 0}});
  EXPECT_EQ(
      refused(Vec3(2.0, 0.0, 0.0)),
      "throw.add.object: nobody has \"ball\" in frame 0: select a wrist and pass it on, or go to a "
      "frame in which a hand has it");
  Do(&session, "held.set", {{"object", "ball"}, {"never", true}});
  Do(&session, "region.add", {{"name", "leg"}, {"first", 2}, {"last", 14}, {"joints", {"r_knee"}}});
  EXPECT_EQ(
      refused(Vec3(2.0, 0.0, 0.0)),
      "throw.add: the region \"leg\" moves joints in frames 2 to 14; throw before or after it");
  Do(&session, "region.remove", {{"region", "leg"}});
  Do(&session, "scene.gravity", {{"gravity", 0}});
  EXPECT_EQ(refused(Vec3(2.0, 0.0, 0.0)), "throw.add.object: without gravity nothing comes down");
}

}  // namespace
}  // namespace hazumi::test
