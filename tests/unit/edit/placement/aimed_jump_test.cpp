// A jump that is aimed at another spot.

#include <cmath>

#include "engine/project/edits/curves.h"
#include "tests/unit/edit/placement/jumps.h"

namespace hazumi::test {
namespace {

using edit::Session;

// Onto the box, as the motion has it on the landing's frame.
void ExpectLandsOn(const Vec3& spot, Session* session) {
  const Motion motion = JumpMotion(session);
  const JumpPhases phases = PhasesOf(*session);
  const Vec3 toes = ToesIn(motion.frames[phases.landing], session);
  EXPECT_LE((toes.head<2>() - spot.head<2>()).norm(), 1e-3);
  EXPECT_NEAR(toes.z(), spot.z(), 0.05);
  EXPECT_LE((ToesIn(motion.frames[phases.end], session) - toes).norm(), 0.01);
  EXPECT_TRUE(motion.warnings.empty());
}

TEST(AimedJump, LandsOnTheNewSpot) {
  Session session;
  AddBox(&session);
  Do(&session, "jump.add", {{"x", 0.5}, {"y", 0.0}});
  ExpectLandsOn({0.5, 0.0, 0.0}, &session);
  Do(&session, "jump.aim", {{"x", 1.15}, {"y", 0.1}});
  ExpectLandsOn({1.15, 0.1, kHigh}, &session);
  Do(&session, "jump.aim", {{"x", 0.45}, {"y", -0.2}});
  ExpectLandsOn({0.45, -0.2, 0.0}, &session);
}

TEST(AimedJump, IsTheOneThatIsAddedThereAtOnce) {
  Session session, other;
  Do(&session, "jump.add", {{"x", 0.5}, {"y", 0.0}, {"height", 0.3}});
  Do(&session, "jump.aim", {{"x", 0.9}, {"y", 0.0}, {"height", 0.5}});
  Do(&other, "jump.add", {{"x", 0.9}, {"y", 0.0}, {"height", 0.5}});
  const JumpPhases phases = PhasesOf(session), expected = PhasesOf(other);
  EXPECT_EQ(phases.take_off, expected.take_off);
  EXPECT_EQ(phases.landing, expected.landing);
  EXPECT_EQ(phases.end, expected.end);
  const Motion motion = JumpMotion(&session), as_added = JumpMotion(&other);
  for (int f = 0; f <= phases.end; ++f) {
    EXPECT_LE((motion.frames[f].com - as_added.frames[f].com).norm(), 0.03) << f;
  }
}

TEST(AimedJump, FollowsABoxThatIsRaised) {
  Session session;
  AddBox(&session);
  Do(&session, "jump.add", {{"x", 1.15}, {"y", 0.0}});
  constexpr double kHigher = 0.7;
  Do(&session, "object.set", {{"object", "box"}, {"z", 0.5 * kHigher}, {"size_z", kHigher}});
  const Motion before = JumpMotion(&session);
  ASSERT_FALSE(before.placement_jumps.empty());
  ASSERT_TRUE(JumpAt(before.placement_jumps[0].frame, session.project().placements));
  Do(&session, "time.frame", {{"frame", before.placement_jumps[0].frame}});
  Do(&session, "jump.aim");
  ExpectLandsOn({1.15, 0.0, kHigher}, &session);
}

TEST(AimedJump, KeepsPosesThatWereChanged) {
  Session session;
  Do(&session, "jump.add", {{"x", 0.5}, {"y", 0.0}});
  const JumpPhases first = PhasesOf(session);
  const int apex = (first.take_off + first.landing) / 2;
  Do(&session, "key.set", {{"curve", "r_shoulder_abduction"}, {"frame", apex}, {"value", 80}});
  Do(&session, "marker.add", {{"frame", first.landing}, {"name", "down"}});
  Do(&session, "jump.aim", {{"x", 0.5}, {"y", 0.0}, {"height", 0.8}});
  const JumpPhases now = PhasesOf(session);
  EXPECT_GT(now.landing - now.take_off, first.landing - first.take_off + 4);
  EXPECT_EQ(session.project().markers[0].frame, now.landing);
  const auto& keys = FindCurve("r_shoulder_abduction", session.project())->keys;
  const auto changed = std::find_if(keys.begin(), keys.end(),
                                    [](const ProjectKey& key) { return key.value == 80.0; });
  ASSERT_NE(changed, keys.end());
  EXPECT_GT(changed->frame, now.take_off);
  EXPECT_LT(changed->frame, now.landing);
  EXPECT_NE(changed->frame, apex);
}

TEST(AimedJump, LeavesWhatComesAfterItWhereItIs) {
  Session session;
  Do(&session, "jump.add", {{"x", 0.5}, {"y", 0.0}, {"height", 0.3}});
  const int end = PhasesOf(session).end;
  Do(&session, "time.range", {{"first", 0}, {"last", end + 20}});
  Do(&session, "key.set", {{"curve", "neck_rotation"}, {"frame", end + 1}, {"value", 40}});
  Do(&session, "jump.aim", {{"x", 0.5}, {"y", 0.0}, {"height", 0.6}});
  EXPECT_EQ(PhasesOf(session).end, end);
  const auto& keys = FindCurve("neck_rotation", session.project())->keys;
  EXPECT_EQ(keys.back().frame, end + 1);
  EXPECT_EQ(keys.back().value, 40);
  const std::string error =
      Refused(&session, "jump.aim", {{"x", 0.5}, {"y", 0.0}, {"height", 3.0}}).ToString();
  EXPECT_NE(error.find("something else begins"), std::string::npos) << error;
}

TEST(AimedJump, TakesARegionInTheFlightAlong) {
  Session session;
  Do(&session, "jump.add", {{"x", 0.5}, {"y", 0.0}, {"height", 0.4}});
  const JumpPhases first = PhasesOf(session);
  Do(&session, "region.add",
     {{"first", first.take_off + 3}, {"last", first.landing}, {"joints", {"r_shoulder+"}}});
  Do(&session, "jump.aim", {{"x", 0.9}, {"y", 0.0}, {"height", 0.7}});
  const JumpPhases now = PhasesOf(session);
  EXPECT_EQ(session.project().regions[0].last_frame, now.landing);
  // What swings by itself has the flight end a little elsewhere than the keys do.
  const Motion motion = JumpMotion(&session);
  const Vec3 toes = ToesIn(motion.frames[now.landing], &session);
  EXPECT_LE((toes.head<2>() - Eigen::Vector2d(0.9, 0.0)).norm(), 0.03);
  EXPECT_NEAR(toes.z(), 0.0, 0.05);
}

TEST(AimedJump, IsOneUndoStepAndSaysWhereThereIsNone) {
  Session session;
  EXPECT_EQ(Refused(&session, "jump.aim", edit::Json::object()).ToString(),
            "jump.aim: there is no jump in this frame: a flight by gravity between two pins");
  Do(&session, "jump.add");
  const Project before = session.project();
  Do(&session, "jump.aim", {{"x", 1.0}, {"y", 0.2}});
  EXPECT_FALSE(session.project() == before);
  Do(&session, "edit.undo");
  EXPECT_TRUE(session.project() == before);
  Do(&session, "time.frame", {{"frame", PhasesOf(session).end}});
  Refused(&session, "jump.aim", edit::Json::object());
}

}  // namespace
}  // namespace hazumi::test
