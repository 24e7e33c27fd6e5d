#include "engine/spatial/degrees.h"
#include "tests/unit/edit/sessions.h"

namespace hazumi::test {
namespace {

using edit::Session;

const ProjectHeldObject& Last(const Session& session) {
  return session.project().held_objects.back();
}

TEST(HeldObjectOperators, ABallIsPutIntoTheSelectedHandAndThrown) {
  Session session;
  Do(&session, "select.joints", {{"joints", {"r_wrist"}}});
  Do(&session, "held.add_ball");
  EXPECT_EQ(Last(session).joint, "r_wrist");
  EXPECT_EQ(Last(session).name, "ball");
  // In the palm: half way along the hand, at its side.
  EXPECT_LE((Last(session).offset_m - Vec3(0.0, 0.037, -0.09175)).norm(), 1e-12);
  Do(&session, "held.set", {{"object", "ball"}, {"release", 7}});
  const Result<const Motion*> motion = session.WholeMotion();
  ASSERT_TRUE(motion.ok()) << motion.error().ToString();
  EXPECT_TRUE(motion.value()->frames[6].objects[0].is_held());
  EXPECT_FALSE(motion.value()->frames[8].objects[0].is_held());
}

TEST(HeldObjectOperators, ChangeWhatIsGiven) {
  Session session;
  Do(&session, "held.add_box", {{"joint", "l_wrist"}, {"name", "brick"}, {"offset_x", 0.1}});
  EXPECT_EQ(Last(session).offset_m, Vec3(0.1, 0.0, 0.0));
  Do(&session, "held.set", {{"object", "brick"}, {"size_z", 0.3}, {"mass", 2}, {"drag", "a"}});
  Do(&session, "held.set", {{"object", "brick"}, {"joint", "r_wrist"}, {"release", 9}});
  EXPECT_EQ(std::get<ProjectBoxShape>(Last(session).shape).size_m, Vec3(0.1, 0.1, 0.3));
  EXPECT_EQ(Last(session).mass_kg, 2.0);
  EXPECT_EQ(Last(session).joint, "r_wrist");
  Do(&session, "held.set", {{"object", "brick"}, {"never", true}});
  EXPECT_EQ(Last(session).release_frame, std::nullopt);
  Do(&session, "held.add_ball", {{"joint", "l_wrist"}, {"name", "brick"}});
  EXPECT_EQ(Last(session).name, "brick 2");
  Do(&session, "held.remove", {{"object", "brick"}});
  EXPECT_EQ(session.project().held_objects.size(), 1u);
  Do(&session, "edit.undo");
  EXPECT_EQ(session.project().held_objects.size(), 2u);
}

TEST(HeldObjectOperators, SayWhatTheyRefuse) {
  Session session;
  const auto refused = [&](const char* id, const edit::Json& given) {
    return Refused(&session, id, given).ToString();
  };
  EXPECT_EQ(refused("held.add_ball", {{"joint", "tail"}}),
            "held.add_ball.joint: there is no joint \"tail\"");
  Do(&session, "held.add_ball", {{"joint", "r_wrist"}});
  EXPECT_EQ(refused("held.set", {{"object", "ball"}, {"size_x", 1}}),
            "held.set.size_x: a ball has none; boxes have");
  EXPECT_EQ(refused("held.set", {{"object", "ball"}, {"mass", 0}}),
            "held.set.held_objects[0].mass_kg: must be greater than 0, is 0");
  EXPECT_EQ(refused("held.set", {{"object", "stone"}, {"mass", 1}}),
            "held.set.object: there is no \"stone\"; there is \"ball\"");
}

Vec3 PositionAt(Session* session, int frame, size_t object = 0) {
  const Result<const Motion*> motion = session->WholeMotion();
  EXPECT_TRUE(motion.ok());
  return motion.ok() ? motion.value()->frames[frame].objects[object].X_WO.p : Vec3::Zero();
}

TEST(HeldObjectOperators, WithoutAHandABallLiesOnTheGround) {
  Session session;
  Do(&session, "held.add_ball", {{"radius", 0.1}});
  EXPECT_EQ(Last(session).joint, "");
  EXPECT_LE((PositionAt(&session, 0) - Vec3(0.5, 0.0, 0.1)).norm(), 1e-12);
  session.set_frame(10);
  Do(&session, "held.pass", {{"object", "ball"}, {"joint", "l_wrist"}});
  EXPECT_LE((PositionAt(&session, 9) - Vec3(0.5, 0.0, 0.1)).norm(), 1e-12);
  EXPECT_EQ(session.WholeMotion().value()->frames[10].objects[0].holder, 0);
}

TEST(HeldObjectOperators, PassItFromHandToHand) {
  Session session;
  Do(&session, "held.add_ball", {{"joint", "r_wrist"}, {"release", 20}});
  Do(&session, "held.pass", {{"object", "ball"}, {"joint", "l_wrist"}, {"frame", 8}});
  EXPECT_EQ(Last(session).release_frame, 8);
  ASSERT_EQ(Last(session).holders.size(), 1u);
  const ProjectHolder& next = Last(session).holders[0];
  EXPECT_EQ(next.joint, "l_wrist");
  EXPECT_EQ(next.first_frame, 8);
  EXPECT_EQ(next.last_frame, 20);  // it is let go when it would have been
  EXPECT_LE((next.offset_m - Vec3(0.0, -0.037, -0.09175)).norm(), 1e-12);  // the left palm
  EXPECT_NE(Refused(&session, "held.pass", {{"object", "ball"}, {"joint", "r_wrist"}, {"frame", 8}})
                .message.find("\"l_wrist\" has it from frame 8 on"),
            std::string::npos);
  Do(&session, "held.remove_holder", {{"object", "ball"}, {"number", 0}});
  EXPECT_TRUE(Last(session).holders.empty());
}

TEST(HeldObjectOperators, LetItGoInTheCurrentFrame) {
  Session session;
  Do(&session, "held.add_ball", {{"joint", "r_wrist"}});
  session.set_frame(12);
  Do(&session, "held.let_go", {{"object", "ball"}});
  EXPECT_EQ(Last(session).release_frame, 12);
  EXPECT_EQ(Refused(&session, "held.let_go", {{"object", "ball"}, {"frame", 15}}).message,
            "nobody has \"ball\" in frame 15");
}

TEST(HeldObjectOperators, MoveTheFramesOfAHolderAndItsNeighboursGiveWay) {
  Session session;
  Do(&session, "held.add_ball", {{"joint", "r_wrist"}, {"release", 20}});
  Do(&session, "held.pass", {{"object", "ball"}, {"joint", "l_wrist"}, {"frame", 8}});
  // They touch: the border is one.
  Do(&session, "held.set_frames", {{"object", "ball"}, {"number", -1}, {"release", 11}});
  EXPECT_EQ(Last(session).release_frame, 11);
  EXPECT_EQ(Last(session).holders[0].first_frame, 11);
  Do(&session, "held.set_frames",
     {{"object", "ball"}, {"number", 0}, {"first", 6}, {"release", 18}});
  EXPECT_EQ(Last(session).release_frame, 6);
  EXPECT_EQ(Last(session).holders[0].first_frame, 6);
  EXPECT_EQ(Last(session).holders[0].last_frame, 18);
}

TEST(HeldObjectOperators, MoveItInTheHandAndOnTheGround) {
  Session session;
  Do(&session, "held.add_ball", {{"joint", "r_wrist"}, {"release", 10}});
  Do(&session, "held.add_box");
  const Vec3 in_hand = PositionAt(&session, 0), on_ground = PositionAt(&session, 0, 1);
  Do(&session, "held.move", {{"object", "ball"}, {"x", 0.05}, {"z", 0.02}});
  EXPECT_LE((PositionAt(&session, 0) - in_hand - Vec3(0.05, 0.0, 0.02)).norm(), 1e-9);
  session.set_frame(15);
  Do(&session, "held.move", {{"object", "box"}, {"y", 1}});
  EXPECT_LE((PositionAt(&session, 0, 1) - on_ground).norm(), 1e-12);
  EXPECT_LE((PositionAt(&session, 15, 1) - on_ground - Vec3(0.0, 1.0, 0.0)).norm(), 1e-9);
  const std::string in_the_air =
      Refused(&session, "held.move", {{"object", "ball"}, {"x", 1}}).message;
  EXPECT_EQ(in_the_air.find("\"ball\" flies in frame 15"), 0u);
}

Mat3 TurnAt(Session* session, int frame) {
  const Result<const Motion*> motion = session->WholeMotion();
  EXPECT_TRUE(motion.ok());
  return motion.ok() ? motion.value()->frames[frame].objects[0].X_WO.R : Mat3::Zero();
}

Mat3 About(const Vec3& axis, double degrees) {
  return Eigen::AngleAxisd(degrees * kDegree, axis.normalized()).toRotationMatrix();
}

TEST(HeldObjectOperators, TurnItInTheHandAboutAnAxisOfTheWorld) {
  Session session;
  Do(&session, "key.set", {{"curve", "r_shoulder_flexion"}, {"frame", 0}, {"value", -50}});
  Do(&session, "held.add_box", {{"joint", "r_wrist"}, {"release", 10}});
  const Mat3 before = TurnAt(&session, 4);
  const Vec3 place = PositionAt(&session, 4);
  session.set_frame(4);
  Do(&session, "held.turn", {{"object", "box"}, {"z", 30}});
  EXPECT_LE((TurnAt(&session, 4) - About(Vec3::UnitZ(), 30) * before).norm(), 1e-9);
  EXPECT_LE((PositionAt(&session, 4) - place).norm(), 1e-12);
  // About an axis between those of the world, on from there.
  Do(&session, "held.turn", {{"object", "box"}, {"x", 60}, {"y", 80}});
  const Mat3 after = About(Vec3(0.6, 0.8, 0.0), 100) * About(Vec3::UnitZ(), 30) * before;
  EXPECT_LE((TurnAt(&session, 4) - after).norm(), 1e-9);
  Do(&session, "edit.undo");
  Do(&session, "edit.undo");
  EXPECT_EQ(TurnAt(&session, 4), before);
  session.set_frame(15);
  EXPECT_EQ(Refused(&session, "held.turn", {{"object", "box"}, {"z", 30}}).message,
            "nobody has \"box\" in frame 15: it is turned in a hand; go to a frame in which one "
            "has it");
}

TEST(HeldObjectOperators, ADragOfItsTurnIsOneStep) {
  Session session;
  Do(&session, "held.add_box", {{"joint", "r_wrist"}});
  for (int i = 0; i < 3; ++i) {
    Do(&session, "held.turn", {{"object", "box"}, {"x", 10}, {"drag", "a"}});
  }
  EXPECT_NE(Last(session).rotation_deg, Vec3::Zero());
  Do(&session, "edit.undo");
  EXPECT_EQ(Last(session).rotation_deg, Vec3::Zero());
}

TEST(HeldObjectOperators, ItsTurnIsSetAndMovesItAlongTheWorldsAxes) {
  Session session;
  Do(&session, "held.add_box",
     {{"joint", "r_wrist"}, {"size_x", 0.4}, {"angle_z", 90}, {"release", 20}});
  EXPECT_EQ(Last(session).rotation_deg, Vec3(90.0, 0.0, 0.0));
  // In the palm it lies by the edge that is across the hand now.
  EXPECT_LE((Last(session).offset_m - Vec3(0.0, 0.2, -0.09175)).norm(), 1e-12);
  const Vec3 before = PositionAt(&session, 0);
  Do(&session, "held.move", {{"object", "box"}, {"x", 0.05}, {"z", 0.02}});
  EXPECT_LE((PositionAt(&session, 0) - before - Vec3(0.05, 0.0, 0.02)).norm(), 1e-9);
  // The next hand has it as this one has, if nothing else is said.
  Do(&session, "held.pass", {{"object", "box"}, {"joint", "l_wrist"}, {"frame", 8}});
  EXPECT_EQ(Last(session).holders[0].rotation_deg, Vec3(90.0, 0.0, 0.0));
  Do(&session, "held.set_holder", {{"object", "box"}, {"number", 0}, {"angle_y", 20}});
  EXPECT_EQ(Last(session).holders[0].rotation_deg, Vec3(90.0, 20.0, 0.0));
  session.set_frame(10);
  Do(&session, "held.turn", {{"object", "box"}, {"z", 10}});
  EXPECT_NE(Last(session).holders[0].rotation_deg, Vec3(90.0, 20.0, 0.0));
  Do(&session, "held.set", {{"object", "box"}, {"angle_x", -15}});
  EXPECT_EQ(Last(session).rotation_deg, Vec3(90.0, 0.0, -15.0));
}

// It flies to the key, which says where it lies from then on.
TEST(HeldObjectOperators, KeyWhereItHasComeDown) {
  Session session;
  Do(&session, "held.add_ball", {{"joint", "r_wrist"}, {"release", 10}});
  session.set_frame(20);
  Do(&session, "held.key", {{"object", "ball"}, {"z", 0.037}});
  EXPECT_EQ(PositionAt(&session, 20).z(), 0.037);
  EXPECT_EQ(PositionAt(&session, 25), PositionAt(&session, 20));
  EXPECT_NE(PositionAt(&session, 19).z(), 0.037);
  // Its keys are keys like others.
  Do(&session, "key.move", {{"curve", "held.ball.z"}, {"frame", 20}, {"to", 20}, {"by", 0.5}});
  EXPECT_EQ(PositionAt(&session, 25).z(), 0.537);
  Do(&session, "edit.undo");
  EXPECT_EQ(PositionAt(&session, 25).z(), 0.037);
}

}  // namespace
}  // namespace hazumi::test
