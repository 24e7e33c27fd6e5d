// Goals: what they say, what an aim writes, and what becomes of that.

#include <algorithm>
#include <cmath>

#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Session;

// The right arm swings freely in frames 2 to 12, and has keys where it is to be then.
void Swing(Session* session) {
  Do(session, "region.add",
     {{"name", "arm"}, {"first", 2}, {"last", 12}, {"joints", {"r_shoulder+"}}});
  Do(session, "key.set", {{"curve", "r_shoulder_flexion"}, {"frame", 12}, {"value", 50}});
  Do(session, "key.set", {{"curve", "r_elbow_flexion"}, {"frame", 12}, {"value", 70}});
}

double MeasuredIn(const Session& session, const std::string& name) {
  for (const auto& measured : session.outcome().measured) {
    if (measured.name == name) return measured.value;
  }
  return std::nan("");
}

const std::vector<ProjectDrive>& Drives(const Session& session) {
  return session.project().regions[0].drives;
}

TEST(Goal, MeetsTheKeysOfTheRegionsJointsByDefault) {
  Session session;
  Swing(&session);
  Do(&session, "time.frame", {{"frame", 12}});
  Do(&session, "goal.add", {{"kind", "pose"}});
  const ProjectGoal& goal = session.project().goals[0];
  EXPECT_EQ(goal.frame, 12);
  EXPECT_EQ(goal.joints, session.project().regions[0].joints);
  Do(&session, "goal.aim", {{"goal", goal.name}});
  EXPECT_LT(MeasuredIn(session, "off_deg"), 0.1);
  EXPECT_GT(MeasuredIn(session, "muscle"), 0.0);
  const Motion& motion = *session.WholeMotion().value();
  const int elbow = session.figure().FindJoint("r_elbow_flexion")->value();
  EXPECT_NEAR(motion.frames[12].before.q[elbow], 70.0 * M_PI / 180.0, 0.002);
}

TEST(Goal, IsOneUndoStepWithItsTorques) {
  Session session;
  Swing(&session);
  Do(&session, "goal.add", {{"kind", "pose"}, {"frame", 12}});
  const Project before = session.project();
  Do(&session, "goal.aim", {{"goal", "goal"}});
  EXPECT_EQ(Drives(session).size(), 7u);
  const Project after = session.project();
  Do(&session, "edit.undo");
  EXPECT_EQ(session.project(), before);
  Do(&session, "edit.redo");
  EXPECT_EQ(session.project(), after);
  Do(&session, "goal.aim", {{"goal", "goal"}});
  EXPECT_EQ(session.project(), after);
}

TEST(Goal, TakesItsTorquesAlong) {
  Session session;
  Swing(&session);
  Do(&session, "goal.add", {{"kind", "pose"}, {"frame", 12}});
  Do(&session, "goal.aim", {{"goal", "goal"}});
  Do(&session, "goal.set", {{"goal", "goal"}, {"name", "there"}});
  for (const ProjectDrive& drive : Drives(session)) EXPECT_EQ(drive.solved_by, "there");
  // A torque that is touched is the animator's.
  Do(&session, "drive.key", {{"region", "arm"}, {"number", 3}, {"frame", 5}, {"torque", 1}});
  EXPECT_EQ(Drives(session)[3].solved_by, "");
  Do(&session, "goal.remove", {{"goal", "there"}});
  ASSERT_EQ(Drives(session).size(), 1u);
  EXPECT_EQ(Drives(session)[0].solved_by, "");
}

TEST(Goal, LetsLooseWithoutGoing) {
  Session session;
  Swing(&session);
  Do(&session, "goal.add", {{"kind", "pose"}, {"frame", 12}});
  Do(&session, "goal.aim", {{"goal", "goal"}});
  Do(&session, "goal.let_loose", {{"region", "arm"}});
  EXPECT_TRUE(Drives(session).empty());
  EXPECT_EQ(session.project().goals.size(), 1u);
}

TEST(Goal, GoesWithItsRegionInTime) {
  Session session;
  Swing(&session);
  Do(&session, "goal.add", {{"kind", "pose"}, {"frame", 12}});
  Do(&session, "key.set", {{"curve", "r_elbow_flexion"}, {"frame", 0}, {"value", 10}});
  Do(&session, "keys.select_all", {{"curves", {"r_shoulder_flexion", "r_elbow_flexion"}}});
  Do(&session, "keys.move", {{"frames", 3}});
  EXPECT_EQ(session.project().regions[0].last_frame, session.project().goals[0].frame);
}

// A point begins where the tip of the limb is.
TEST(Goal, OfAPointBeginsAtTheTipAsItMoves) {
  Session session;
  Swing(&session);
  Do(&session, "goal.add", {{"kind", "point"}, {"joint", "r_wrist"}, {"frame", 12}});
  const ProjectGoal& goal = session.project().goals[0];
  EXPECT_LT(goal.offset_m.z(), -0.1);
  EXPECT_GT(goal.position_m.norm(), 0.5);
  Do(&session, "goal.aim", {{"goal", "goal"}});
  EXPECT_EQ(MeasuredIn(session, "loose"), 1.0);
}

TEST(Goal, OfAnotherKindHasItsFieldsAlone) {
  Session session;
  Swing(&session);
  Do(&session, "goal.add", {{"kind", "pose"}, {"frame", 12}, {"tolerance", 0.3}});
  Do(&session, "goal.set", {{"goal", "goal"}, {"kind", "point"}, {"joint", "r_wrist"}});
  const ProjectGoal& goal = session.project().goals[0];
  EXPECT_TRUE(goal.joints.empty());
  EXPECT_EQ(goal.tolerance_deg, kDefaultGoalToleranceDeg);
  EXPECT_EQ(goal.joint, "r_wrist");
}

TEST(Reach, MakesRegionGoalAndTorquesInOneStep) {
  Session session;
  const Project before = session.project();
  Do(&session, "goal.reach",
     {{"joint", "r_wrist"}, {"x", 0.35}, {"y", -0.3}, {"z", 1.0}, {"frame", 12}});
  EXPECT_LT(MeasuredIn(session, "off_cm"), 0.5);
  ASSERT_EQ(session.project().regions.size(), 1u);
  EXPECT_EQ(session.project().regions[0].first_frame, 2);
  EXPECT_EQ(session.project().regions[0].last_frame, 12);
  ASSERT_EQ(session.project().goals.size(), 1u);
  // The point is the tip of the hand, and is dragged.
  EXPECT_LT(session.project().goals[0].offset_m.z(), -0.1);
  EXPECT_TRUE(session.project().goals[0].rests);
  Do(&session, "goal.set", {{"goal", "reach"}, {"rests", false}});
  Do(&session, "goal.reach",
     {{"joint", "r_wrist"}, {"x", 0.3}, {"y", -0.3}, {"z", 1.1}, {"frame", 12}});
  EXPECT_FALSE(session.project().goals[0].rests);
  EXPECT_EQ(session.project().goals.size(), 1u);
  EXPECT_EQ(session.project().regions.size(), 1u);
  for (int i = 0; i < 3; ++i) Do(&session, "edit.undo");
  EXPECT_EQ(session.project(), before);
}

TEST(Reach, SaysWhatIsTooFarAway) {
  Session session;
  EXPECT_TRUE(Refused(&session, "goal.reach",
                      {{"joint", "r_wrist"}, {"x", 3}, {"y", 0}, {"z", 1}, {"frame", 12}})
                  .ToString()
                  .starts_with("goal.reach.goal: \"reach\" is out of reach in frame 12: r_wrist "
                               "comes no nearer than"));
  EXPECT_TRUE(session.project().goals.empty());
  EXPECT_EQ(Refused(&session, "goal.reach",
                    {{"joint", "r_wrist"}, {"x", 0.3}, {"y", 0}, {"z", 1}, {"frame", 0}})
                .ToString(),
            "goal.reach.frame: there is no time before frame 0: reach in a later frame");
}

}  // namespace
}  // namespace hazumi::test
