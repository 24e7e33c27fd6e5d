// A held object that is thrown onto a spot by a region of the animator.

#include <algorithm>
#include <cmath>

#include "engine/makers/throws/throw_path.h"
#include "engine/spatial/degrees.h"
#include "tests/unit/edit/held/throws.h"

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

TEST(ThrowOnto, TheSlowestThrowLeavesAtTheAngleOfTheTextbook) {
  // On the level: 45 degrees, v^2 = g d, so that it rises by d / 4.
  EXPECT_NEAR(makers::HeightOfSlowestThrow(Vec3::Zero(), Vec3(3.0, 4.0, 0.0), 9.81), 1.25, 1e-9);
  // Any other height takes more speed.
  const Vec3 from(0.0, 0.0, 1.3), spot(2.0, 1.0, 0.4);
  const double best = makers::HeightOfSlowestThrow(from, spot, 9.81);
  const auto speed = [&](double height) {
    return makers::ThrowOver(from, spot, height, 9.81).velocity.norm();
  };
  EXPECT_LT(speed(best), speed(0.95 * best));
  EXPECT_LT(speed(best), speed(1.05 * best));
  const makers::ThrowPath path = makers::ThrowOver(from, spot, best, 9.81);
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
    const Motion& motion = ThrowMotion(&session);
    EXPECT_LE((LandsAt(motion, ReleaseOf(session), lies.z()) - lies).norm(), 0.006);
    EXPECT_LE((motion.frames.back().objects[0].X_WO.p - lies).norm(), 1e-9);
    Do(&session, "edit.undo");
    EXPECT_EQ(session.project().held_objects[0].position, ProjectPosition());
  }
}

TEST(ThrowOnto, OnlyTheSwingOfTheArmAndTheBallAreKeyed) {
  Session session;
  AddThrow(&session);
  Project before = session.project();
  Do(&session, "held.throw_onto", Onto(Vec3(1.5, -0.4, 0.0)));
  for (const auto& [name, curve] : session.project().joints) {
    const auto old = std::find_if(before.joints.begin(), before.joints.end(),
                                  [&name = name](const auto& entry) { return entry.name == name; });
    for (const ProjectKey& key : curve.keys) {
      if (key.frame >= 2.0 && key.frame <= kRelease && name.starts_with("r_")) continue;
      EXPECT_TRUE(old != before.joints.end() &&
                  std::find(old->value.keys.begin(), old->value.keys.end(), key) !=
                      old->value.keys.end())
          << name << " " << key.frame;
    }
  }
  ASSERT_EQ(session.project().regions.size(), 1u);
  before.regions[0].first_frame = kRelease;
  EXPECT_EQ(session.project().regions, before.regions);
}

// An arm that is drawn back before the region throws from there, with no step in its speed.
TEST(ThrowOnto, TheWindUpStaysAsItIs) {
  constexpr int kWindUp = 12;
  Session session;
  Do(&session, "time.range", {{"first", 0}, {"last", 40}});
  Do(&session, "held.add_ball", {{"joint", "r_wrist"}, {"release", kWindUp + 8}});
  Do(&session, "key.set", {{"curve", "r_shoulder_flexion"}, {"frame", 0}, {"value", 0}});
  Do(&session, "key.set", {{"curve", "r_shoulder_flexion"}, {"frame", kWindUp}, {"value", -40}});
  Do(&session, "region.add",
     {{"name", "arm"},
      {"first", kWindUp + 4},
      {"last", kWindUp + 14},
      {"joints", {"r_shoulder+"}}});
  const std::vector<MotionFrame> before = ThrowMotion(&session).frames;
  Do(&session, "held.throw_onto", Onto(Vec3(2.5, 0.3, 0.0)));
  const Motion& motion = ThrowMotion(&session);
  for (int frame = 0; frame <= kWindUp; ++frame) {
    EXPECT_LE((motion.frames[frame].q - before[frame].q).lpNorm<Eigen::Infinity>(), 0.5 * kDegree)
        << frame;
  }
  EXPECT_EQ(ReleaseOf(session), kWindUp + 8);
  const JointIndex shoulder = *session.figure().FindJoint("r_shoulder_flexion");
  for (int frame = 1; frame <= ReleaseOf(session); ++frame) {
    const MotionFrame& at = motion.frames[frame];
    EXPECT_NEAR(at.before.qd[shoulder.value()], at.after.qd[shoulder.value()], 1e-6) << frame;
  }
}

TEST(ThrowOnto, KeysOfAnOlderFlightAreTakenAway) {
  Session session;
  AddThrow(&session);
  Do(&session, "held.throw_onto", Onto(Vec3(1.5, -0.4, 0.0)));
  for (const int frame : {ReleaseOf(session) + 1, ReleaseOf(session) + 3}) {
    Do(&session, "time.frame", {{"frame", frame}});
    Do(&session, "held.key", {{"object", "ball"}, {"x", 9}, {"y", 9}, {"z", 9}});
  }
  Do(&session, "time.frame", {{"frame", 0}});
  Do(&session, "held.throw_onto", Onto(Vec3(1.5, -0.2, 0.0)));
  EXPECT_EQ(session.project().held_objects[0].position.curves[0].keys.size(), 1u);
  EXPECT_EQ(session.project().goals.size(), 1u);
}

// The goal of a throw follows a release that is moved.
TEST(ThrowOnto, OfAReleaseThatWasMovedItIsTheSameGoal) {
  Session session;
  AddThrow(&session);
  Do(&session, "held.throw_onto", Onto(Vec3(1.5, -0.4, 0.0)));
  Do(&session, "held.set", {{"object", "ball"}, {"release", 14}});
  Do(&session, "held.throw_onto", Onto(Vec3(1.5, -0.4, 0.0)));
  ASSERT_EQ(session.project().goals.size(), 1u);
  EXPECT_EQ(session.project().goals[0].frame, ReleaseOf(session));
}

TEST(ThrowOnto, ItRisesAsHighAsItIsTold) {
  Session session;
  AddThrow(&session);
  Json onto = Onto(Vec3(1.5, -0.4, 0.0));
  onto["height"] = 0.8;
  Do(&session, "held.throw_onto", onto);
  const Motion& motion = ThrowMotion(&session);
  EXPECT_NEAR(RiseOf(motion, ReleaseOf(session)), 0.8, 0.02);
}

TEST(ThrowOnto, ItGoesOverWhatStandsInBetween) {
  Session session;
  AddThrow(&session);
  const Vec3 spot(2.2, -0.3, 0.0);
  Do(&session, "held.throw_onto", Onto(spot));
  const double low = RiseOf(ThrowMotion(&session), ReleaseOf(session));
  Do(&session, "object.add_box",
     {{"name", "wall"}, {"x", 1.5}, {"z", 0.4}, {"size_x", 0.2}, {"size_y", 3}, {"size_z", 0.8}});
  Do(&session, "held.throw_onto", Onto(spot));
  const Motion& motion = ThrowMotion(&session);
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
            "begins there or before");
  Do(&session, "region.add",
     {{"name", "arm"}, {"first", 2}, {"last", 14}, {"joints", {"r_shoulder+"}}});
  EXPECT_NE(refused(Vec3(90.0, 0.0, 0.0)).find("the arm cannot throw it there: it comes down "),
            std::string::npos);
  Do(&session, "scene.gravity", {{"gravity", 0}});
  EXPECT_EQ(refused(Vec3(1.5, 0.0, 0.0)), "without gravity nothing comes down");
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

}  // namespace
}  // namespace hazumi::test
