// A held object that is thrown onto a spot: start rates are found, keys are what is left.

#include <algorithm>
#include <cmath>

#include "engine/dynamics/kinematics.h"
#include "engine/placement/contact.h"
#include "engine/spatial/degrees.h"
#include "tests/unit/edit/sessions.h"
#include "ui/edit/operators/held/throw_path.h"

namespace hazumi::test {
namespace {

using edit::Json;
using edit::Session;

constexpr int kRelease = 10;

// The right arm swings from a wind-up and lets go of a ball.
void AddThrow(Session* session) {
  Do(session, "time.range", {{"first", 0}, {"last", 30}});
  Do(session, "held.add_ball", {{"joint", "r_wrist"}, {"release", kRelease}});
  Do(session, "key.set", {{"curve", "r_shoulder_flexion"}, {"frame", 2}, {"value", -40}});
  Do(session, "region.add",
     {{"name", "arm"}, {"first", 2}, {"last", 14}, {"joints", {"r_shoulder+"}}});
}

Json Onto(const Vec3& spot) {
  return {{"object", "ball"}, {"x", spot.x()}, {"y", spot.y()}, {"z", spot.z()}};
}

const Motion& MotionOf(Session* session) {
  const Result<const Motion*> motion = session->WholeMotion();
  EXPECT_TRUE(motion.ok()) << (motion.ok() ? "" : motion.error().ToString());
  return *motion.value();
}

Vec3 BallIn(const Motion& motion, int frame) { return motion.frames[frame].objects[0].X_WO.p; }

int ReleaseOf(const Session& session) {
  return session.project().held_objects[0].release_frame.value();
}

// Where the parabola through its first two frames of flight is as high as the ball lies.
Vec3 LandsAt(const Motion& motion, int release, double height) {
  const double dt = motion.rate.SecondsAt(1), g = 9.81;
  const Vec3 p = BallIn(motion, release);
  const Vec3 v = (BallIn(motion, release + 1) - p) / dt + Vec3(0.0, 0.0, 0.5 * g * dt);
  const double t = (v.z() + std::sqrt(v.z() * v.z() + 2.0 * g * (p.z() - height))) / g;
  return p + t * v - Vec3(0.0, 0.0, 0.5 * g * t * t);
}

// Above where it is let go [m].
double RiseOf(const Motion& motion, int release) {
  double highest = 0.0;
  for (int frame = release; frame < static_cast<int>(motion.frames.size()); ++frame) {
    highest = std::max(highest, BallIn(motion, frame).z());
  }
  return highest - BallIn(motion, release).z();
}

TEST(ThrowOnto, TheSlowestThrowLeavesAtTheAngleOfTheTextbook) {
  // On the level: 45 degrees, v^2 = g d, so that it rises by d / 4.
  EXPECT_NEAR(edit::HeightOfSlowestThrow(Vec3::Zero(), Vec3(3.0, 4.0, 0.0), 9.81), 1.25, 1e-9);
  // Any other height takes more speed.
  const Vec3 from(0.0, 0.0, 1.3), spot(2.0, 1.0, 0.4);
  const double best = edit::HeightOfSlowestThrow(from, spot, 9.81);
  const auto speed = [&](double height) {
    return edit::ThrowOver(from, spot, height, 9.81).velocity.norm();
  };
  EXPECT_LT(speed(best), speed(0.95 * best));
  EXPECT_LT(speed(best), speed(1.05 * best));
  const edit::ThrowPath path = edit::ThrowOver(from, spot, best, 9.81);
  const Vec3 down = from + path.seconds * path.velocity -
                    Vec3(0.0, 0.0, 0.5 * 9.81 * path.seconds * path.seconds);
  EXPECT_LE((down - spot).norm(), 1e-12);
}

TEST(ThrowOnto, TheBallComesDownOnTheSpotAndLiesThere) {
  for (const Vec3& spot : {Vec3(1.5, -0.4, 0.0), Vec3(2.5, 0.3, 0.0), Vec3(1.2, -1.0, 0.3)}) {
    Session session;
    AddThrow(&session);
    Do(&session, "held.throw_onto", Onto(spot));
    const Vec3 lies = spot + Vec3(0.0, 0.0, 0.037);
    const Motion& motion = MotionOf(&session);
    EXPECT_LE((LandsAt(motion, ReleaseOf(session), lies.z()) - lies).norm(), 0.006);
    EXPECT_LE((motion.frames.back().objects[0].X_WO.p - lies).norm(), 1e-9);
    Do(&session, "edit.undo");
    EXPECT_EQ(session.project().held_objects[0].position, ProjectPosition());
  }
}

TEST(ThrowOnto, OnlyTheStartOfTheRegionAndTheBallAreKeyed) {
  Session session;
  AddThrow(&session);
  Project before = session.project();
  Do(&session, "held.throw_onto", Onto(Vec3(1.5, -0.4, 0.0)));
  for (const auto& [name, curve] : session.project().joints) {
    const auto old = std::find_if(before.joints.begin(), before.joints.end(),
                                  [&](const auto& entry) { return entry.name == name; });
    for (const ProjectKey& key : curve.keys) {
      if (key.frame == 2.0) continue;
      EXPECT_TRUE(old != before.joints.end() &&
                  std::find(old->value.keys.begin(), old->value.keys.end(), key) !=
                      old->value.keys.end())
          << name << " " << key.frame;
    }
  }
  EXPECT_EQ(session.project().regions, before.regions);
}

// A start that is much faster than the keys arrive would whirl the arm back before it.
TEST(ThrowOnto, TheWindUpStaysAsItIs) {
  constexpr int kStart = 12;
  Session session;
  Do(&session, "time.range", {{"first", 0}, {"last", 40}});
  Do(&session, "held.add_ball", {{"joint", "r_wrist"}, {"release", kStart + 8}});
  Do(&session, "key.set", {{"curve", "r_shoulder_flexion"}, {"frame", 0}, {"value", 0}});
  Do(&session, "key.set", {{"curve", "r_shoulder_flexion"}, {"frame", kStart}, {"value", -40}});
  Do(&session, "region.add",
     {{"name", "arm"}, {"first", kStart}, {"last", kStart + 12}, {"joints", {"r_shoulder+"}}});
  const std::vector<MotionFrame> before = MotionOf(&session).frames;
  Do(&session, "held.throw_onto", Onto(Vec3(2.5, 0.3, 0.0)));
  const Motion& motion = MotionOf(&session);
  const JointIndex shoulder = *session.figure().FindJoint("r_shoulder_flexion");
  const double faster =
      motion.frames[kStart].after.qd[shoulder.value()] - before[kStart].after.qd[shoulder.value()];
  const double bent = 4.0 / 27.0 * motion.rate.SecondsAt(kStart) * std::abs(faster);
  ASSERT_GT(bent, 6.0 * kDegree);  // were the curve to arrive as fast
  for (int frame = 0; frame <= kStart; ++frame) {
    EXPECT_LE((motion.frames[frame].q - before[frame].q).lpNorm<Eigen::Infinity>(), 3.0 * kDegree)
        << frame;
  }
}

// Whatever it was told of the time after the new release would act now that it is let go then.
TEST(ThrowOnto, KeysOfAnOlderFlightAreTakenAwayFromTheEarlierReleaseOn) {
  Session session;
  AddThrow(&session);
  Do(&session, "held.throw_onto", Onto(Vec3(1.5, -0.4, 0.0)));
  const int release = ReleaseOf(session);
  Do(&session, "held.set", {{"object", "ball"}, {"release", 14}});
  for (const int frame : {release + 1, 13}) {
    Do(&session, "time.frame", {{"frame", frame}});
    Do(&session, "held.key", {{"object", "ball"}, {"x", 9}, {"y", 9}, {"z", 9}});
  }
  Do(&session, "time.frame", {{"frame", 0}});
  Do(&session, "held.throw_onto", Onto(Vec3(1.5, -0.4, 0.0)));
  ASSERT_LT(ReleaseOf(session), 13);
  EXPECT_EQ(session.project().held_objects[0].position.curves[0].keys.size(), 1u);
}

TEST(ThrowOnto, ItRisesAsHighAsItIsTold) {
  Session session;
  AddThrow(&session);
  Json onto = Onto(Vec3(1.5, -0.4, 0.0));
  onto["height"] = 0.8;
  Do(&session, "held.throw_onto", onto);
  const Motion& motion = MotionOf(&session);
  EXPECT_NEAR(RiseOf(motion, ReleaseOf(session)), 0.8, 0.02);
}

TEST(ThrowOnto, ItGoesOverWhatStandsInBetween) {
  Session session;
  AddThrow(&session);
  const Vec3 spot(2.2, -0.3, 0.0);
  Do(&session, "held.throw_onto", Onto(spot));
  const double low = RiseOf(MotionOf(&session), ReleaseOf(session));
  Do(&session, "object.add_box",
     {{"name", "wall"}, {"x", 1.5}, {"z", 0.4}, {"size_x", 0.2}, {"size_y", 3}, {"size_z", 0.8}});
  Do(&session, "held.throw_onto", Onto(spot));
  const Motion& motion = MotionOf(&session);
  EXPECT_GT(RiseOf(motion, ReleaseOf(session)), low);
  for (const MotionFrame& frame : motion.frames) {
    const Vec3 p = frame.objects[0].X_WO.p;
    EXPECT_FALSE(std::abs(p.x() - 1.5) < 0.1 && p.z() < 0.8) << frame.frame;
  }
  Do(&session, "object.set", {{"object", "wall"}, {"z", 2.5}, {"size_z", 5}});
  EXPECT_EQ(Refused(&session, "held.throw_onto", Onto(spot)).message,
            "\"wall\" is in the way; choose a spot that is open from above");
}

TEST(ThrowOnto, ItSaysWhatItCannotDo) {
  Session session;
  Do(&session, "held.add_ball", {{"joint", "r_wrist"}});
  const auto refused = [&](const Vec3& spot) {
    return Refused(&session, "held.throw_onto", Onto(spot)).message;
  };
  EXPECT_EQ(refused(Vec3(1.5, 0.0, 0.0)), "nobody lets go of \"ball\": let go of it first");
  Do(&session, "held.set", {{"object", "ball"}, {"release", kRelease}});
  EXPECT_EQ(refused(Vec3(1.5, 0.0, 0.0)),
            "no dynamics region moves r_wrist in frame 10, in which it lets go: mark one that "
            "begins before that");
  Do(&session, "region.add",
     {{"name", "arm"}, {"first", 2}, {"last", 14}, {"joints", {"r_shoulder+"}}});
  EXPECT_NE(refused(Vec3(90.0, 0.0, 0.0)).find("let go in frame 10 it misses by "),
            std::string::npos);
  Do(&session, "scene.gravity", {{"gravity", 0}});
  EXPECT_EQ(refused(Vec3(1.5, 0.0, 0.0)), "without gravity nothing comes down");
}

// A ball in the right hand, and nothing else.
void AddBall(Session* session) { Do(session, "held.add_ball", {{"joint", "r_wrist"}}); }

TEST(AddThrow, TheBallComesDownOnTheSpotAndLiesThere) {
  for (const Vec3& spot : {Vec3(1.5, -0.4, 0.0), Vec3(3.0, 0.8, 0.0), Vec3(1.8, -1.5, 0.5)}) {
    Session session;
    AddBall(&session);
    const Project before = session.project();
    Do(&session, "throw.add", Onto(spot));
    const Vec3 lies = spot + Vec3(0.0, 0.0, 0.037);
    const Motion& motion = MotionOf(&session);
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
  const Motion& motion = MotionOf(&session);
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
      for (const MotionFrame& frame : MotionOf(&session).frames) {
        ComputePositions(session.figure(), frame.X_WR, frame.q, &ws);
        EXPECT_GE(Clearance(session.figure(), session.animation()->scene, ws), -kDeep)
            << hand << ", " << spot.x() << " m ahead, frame " << frame.frame;
      }
    }
  }
}

// When it lies on the spot.
int DownAt(const Session& session) {
  return static_cast<int>(session.project().held_objects[0].position.curves[0].keys.back().frame);
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

TEST(ThrowOnto, AClipThatEndsSoonAfterItCameDownIsMadeLonger) {
  for (const int left : {0, 1, 5}) {
    Session session;
    AddThrow(&session);
    Do(&session, "held.throw_onto", Onto(Vec3(1.5, -0.2, 0.0)));
    Do(&session, "time.range", {{"first", 0}, {"last", DownAt(session) + left}});
    Do(&session, "held.throw_onto", Onto(Vec3(1.5, -0.2, 0.0)));
    EXPECT_GE(session.project().frames.last, DownAt(session) + 15) << left;
  }
}

// The arm swings forward, and no joint turns farther than it can.
TEST(AddThrow, TheArmSwingsForwardWithinItsLimits) {
  Session session;
  AddBall(&session);
  Do(&session, "throw.add", Onto(Vec3(2.2, 0.0, 0.0)));
  const Motion& motion = MotionOf(&session);
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
  for (size_t i = 0; i < MotionOf(&right).frames.size(); ++i) {
    const Vec3 p = MotionOf(&right).frames[i].objects[0].X_WO.p;
    const Vec3 mirrored(p.x(), -p.y(), p.z());
    EXPECT_LE((MotionOf(&left).frames[i].objects[0].X_WO.p - mirrored).norm(), 0.01) << i;
  }
}

TEST(AddThrow, AFigureThatOnlyStandsIsTurnedToTheSpot) {
  for (const Vec3& spot : {Vec3(0.2, 2.0, 0.0), Vec3(-1.5, -1.0, 0.0)}) {
    Session session;
    AddBall(&session);
    Do(&session, "throw.add", Onto(spot));
    const Motion& motion = MotionOf(&session);
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
    const Motion& motion = MotionOf(&session);
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
    for (size_t i = 0; i < MotionOf(&at_once).frames.size(); ++i) {
      const auto ball = [&](Session* session) {
        return MotionOf(session).frames[i].objects[0].X_WO.p;
      };
      EXPECT_LE((ball(&again) - ball(&at_once)).norm(), 0.02) << wanted.spot.transpose() << i;
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
